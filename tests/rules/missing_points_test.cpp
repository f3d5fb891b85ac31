//! Words without a decimal point where the others of the file have one: lengths and dwells.
#include "tests/rules/raised.hpp"
#include "tests/support/linted.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Ten whole lengths with a point, on lines 2 to 6, before the blocks.
std::string among_points(const std::string& blocks) {
    std::string text = "O1(PLATE)\n";
    for (int i = 1; i <= 5; ++i) text += "G1 X" + std::to_string(i) + "0. Y5. F100.\n";
    return text + blocks + "\nM30\n";
}

std::vector<std::string> found_on(std::string_view control, std::string_view code, const std::string& text) {
    cli::Overrides overrides;
    overrides.control = std::string(control);
    overrides.select = {std::string(code)};
    return codes(lint_texts({{"O1.nc", text}}, std::move(overrides)));
}

TEST(LengthWithoutItsPoint, IsToldAmongOthersThatHaveOne) {
    EXPECT_THAT(lines_raised("MAC552", among_points("X60")), ElementsAre(7));
    EXPECT_THAT(
        messages_raised("MAC552", among_points("X60")),
        ElementsAre("Length without its point: 'X60' counts in least increments, and 10 of the 11 whole "
                    "lengths of the file have a point. Write 'X60.' if that is the length."));
    EXPECT_THAT(lines_raised("MAC552", among_points("X#1\nX60")), ElementsAre(8));
    EXPECT_THAT(lines_raised("MAC552", among_points("G2 X5. Y5. R10")), ElementsAre(7));
}

TEST(LengthWithoutItsPoint, IsAHabitWhereMoreThanOneOfTenLacksIt) {
    EXPECT_THAT(lines_raised("MAC552", among_points("X60\nX70")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC552", "O1\nG1 X10. Y5.\nX20. Y6.\nX60\nM30\n"), IsEmpty()) << "few of them";
    std::string trimmed = "O1\n";
    for (int i = 0; i < 30; ++i) trimmed += "G1 X" + std::to_string(i) + ".5 Y2.25\n";
    EXPECT_THAT(lines_raised("MAC552", trimmed + "X60\nM30\n"), IsEmpty()) << "a post writes 60.0 as 60";
}

TEST(LengthWithoutItsPoint, IsNoneWhereTheWordIsAnotherOrZero) {
    for (const std::string_view block : {"X0", "G0 X12.5", "G4 X500", "G10 L2 P1 X5", "G65 P9001 X60",
                                         "M200 X60", "G81 X10. Z-5. R2. K3", "G28 X60", "T60", "G1 X#1"})
        EXPECT_THAT(lines_raised("MAC552", among_points(std::string(block))), IsEmpty()) << block;
}

TEST(LengthWithoutItsPoint, IsALengthInMillimetresOnSomeControls) {
    EXPECT_THAT(found_on("nct", "MAC552", among_points("X60")), IsEmpty());
    EXPECT_THAT(found_on("fanuc-30i", "MAC552", among_points("X60")), ElementsAre("MAC552"));
    const std::string call = "O1\nG65 P9408 X100 Y36.\nM30\nO9408\nG0 X#24 Y#25\nM99\n";
    EXPECT_THAT(found_on("fanuc-16i", "MAC408", call), ElementsAre("MAC408"));
    EXPECT_THAT(found_on("nct", "MAC408", call), IsEmpty());
}

TEST(LengthWithoutItsPoint, IsNotLookedForInProgramsThatOnlyAPostProcessorWrites) {
    std::string text = "O1\n";
    for (int i = 0; i < 5100; ++i) text += "G1 X" + std::to_string(i % 90 + 1) + ". Y5.\n";
    EXPECT_THAT(lines_raised("MAC552", text + "X60\nM30\n"), IsEmpty());
}

TEST(DwellInAnotherUnit, IsOneWithoutAPointAmongLengthsThatHaveOne) {
    EXPECT_THAT(
        messages_raised("MAC566", among_points("G4 X2")),
        ElementsAre("Dwell of thousandths of a second: 'X2' has no point, as the lengths of the file have, "
                    "and waits for 2 ms. Write 'X2.' for 2 seconds."));
    EXPECT_THAT(lines_raised("MAC566", among_points("G4 U2")), ElementsAre(7));
    EXPECT_THAT(lines_raised("MAC566", among_points("G4 X500")), IsEmpty()) << "half a second";
    EXPECT_THAT(lines_raised("MAC566", "O1\nG1 X10 Y5\nG4 X2\nM30\n"), IsEmpty())
        << "the control may count so";
}

TEST(DwellInAnotherUnit, IsOneOfManyMinutes) {
    EXPECT_THAT(lines_raised("MAC566", "O1\nG4 X500.\nG4 X30.\nG4 P5000\nM30\n"), ElementsAre(2));
}

TEST(DwellInAnotherUnit, OfAFewMillisecondsIsToldOnRequest) {
    EXPECT_THAT(lines_raised("MAC566", "O1\nG4 P2\nM30\n"), ElementsAre(2));
    const auto found = codes(lint_text("O1\nG4 P2\nM30\n"));
    EXPECT_THAT(found, testing::Not(testing::Contains("MAC566")));
}

} // namespace
} // namespace maclint::test
