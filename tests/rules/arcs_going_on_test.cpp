//! Blocks that go on with an arc: each needs a centre or a radius as the one that names G2 does.
#include "tests/support/linted.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// "5 022": the line and the alarm of each word that is missed.
std::vector<std::string> missed(const std::string& blocks, const std::string& control = "fanuc-30i") {
    cli::Overrides overrides;
    overrides.dialect = find_dialect("fanuc");
    overrides.control = control;
    overrides.select = {"MAC523"};
    std::vector<std::string> all;
    for (const auto& [finding, suppressed] :
         lint_texts({{"example.nc", "O1(PLATE)\nG17 G90 G0 X0 Y0\n" + blocks + "G0 Z50.\nM30\n"}},
                    std::move(overrides))
             .findings)
        all.push_back(std::to_string(finding.source->position(finding.span.begin).line) + " " +
                      std::string(finding.alarm));
    return all;
}

TEST(ArcsGoingOn, WantACentreOrARadiusInEachBlock) {
    EXPECT_THAT(missed("G2 X10. Y10. R10.\nX20.\n"), ElementsAre("4 022"));
    EXPECT_THAT(missed("G2 X10. Y10. R10.\nX20. R5.\nY30. J5.\nZ1. (R1 FREE)\n"), ElementsAre("6 022"));
}

TEST(ArcsGoingOn, AreToldOnceEach) {
    EXPECT_THAT(missed("G2 X10. R10.\nX20.\nX30.\nG1 X40.\nG3 X50. R10.\nX60.\n"),
                ElementsAre("4 022", "8 022"));
}

TEST(ArcsGoingOn, EndWithTheNextMoveOfAnotherKind) {
    EXPECT_THAT(missed("G2 X10. R10.\nG1 X20.\nX30.\n"), IsEmpty());
    EXPECT_THAT(missed("G2 X10. R10.\nG1\nX30.\n"), IsEmpty());
    EXPECT_THAT(missed("G2 X10. R10.\nG81 X20. Z-5. R2. F100.\nX30.\nG80\n"), IsEmpty());
}

TEST(ArcsGoingOn, AreLeftToCodesThatTakeTheAxesThemselves) {
    EXPECT_THAT(missed("G2 X10. R10.\nG4 X1.\nG52 X5.\nG28 Z0\n"), IsEmpty());
    EXPECT_THAT(missed("G2 X10. R10.\nG91 X5.\n"), ElementsAre("4 022"));
}

TEST(ArcsGoingOn, GoOnFromAndIntoBlocksWithVariables) {
    EXPECT_THAT(missed("G2 X10. R10.\n#1=5\nX20.\n"), ElementsAre("5 022"));
    EXPECT_THAT(missed("#1=5\nG2 X10. R#1\nX20.\n"), ElementsAre("5 022"));
    EXPECT_THAT(missed("G2 X10. R10.\nX#500\n"), ElementsAre("4 022"));
    EXPECT_THAT(missed("G2 X10. R10.\nX#500 R#501\n"), IsEmpty());
}

TEST(ArcsGoingOn, AreNotSureWhereAJumpMayComeWithAnotherMove) {
    EXPECT_THAT(missed("G1 X5.\nIF[#500EQ1]GOTO10\nG2 X10. R10.\nN10 X20.\n"), IsEmpty());
}

TEST(ArcsGoingOn, AreFoundWhateverEndsTheLines) {
    const std::string text = "O1(PLATE)\rG17 G90 G0 X0 Y0\rG2 X10. R10.\rX20. R5.\rX30.\rG0 Z50.\rM30\r";
    cli::Overrides overrides;
    overrides.control = "fanuc-30i";
    overrides.select = {"MAC523"};
    EXPECT_THAT(codes(lint_texts({{"example.nc", text}}, std::move(overrides))), ElementsAre("MAC523"));
}

TEST(ArcsGoingOn, AreFoundInSmallLetters) {
    EXPECT_THAT(missed("g2 x10. y10. r10.\nx20.\ng1 x5.\nG3 x10. r10.\nx30.\n"),
                ElementsAre("4 022", "7 022"));
}

TEST(ArcsGoingOn, AreOnlyToldOfControlsThatNeedTheWords) {
    EXPECT_THAT(missed("G2 X10. R10.\nX20.\n", "haas"), IsEmpty());
}

} // namespace
} // namespace maclint::test
