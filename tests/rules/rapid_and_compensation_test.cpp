//! Rules that hold moves against each other: MAC510, MAC513, MAC535, MAC555, MAC585.
#include "tests/rules/raised.hpp"
#include "tests/support/linted.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using test::lines_raised;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

// ---- MAC555

std::vector<std::uint32_t> rapid(const std::string& blocks) {
    return lines_raised("MAC555", "O9555\nG21 G17 G90 G54 G0 X-20. Y-20.\nG43 H1 Z5.\n" + blocks + "M30\n");
}

TEST(RapidThroughWork, CrossesWhatIsCutLater) {
    const std::string later = "G1 X90. F500.\nY0\nX-20.\nG0 Z50.\n";
    EXPECT_THAT(rapid("G1 Z-6. F300.\nG0 X0\nY70.\n" + later), ElementsAre(6));
    EXPECT_THAT(rapid("G1 Z-6. F300.\nG1 X0\nY70.\n" + later), IsEmpty());
    EXPECT_THAT(rapid("G1 Z-6. F300.\nG0 X0\nZ2.\nY70.\nG1 Z-6.\n" + later), IsEmpty());
    EXPECT_THAT(rapid("G1 Z-6. F300.\nG0 X0\nM98 P77\nY70.\n" + later), IsEmpty());
    EXPECT_THAT(rapid("G1 Z-6. F300.\nG0 X0\nY70.\nG55 G0 X90. Y90. Z2.\nG1 Z-6.\n" + later), IsEmpty())
        << "another part";
    EXPECT_THAT(rapid("G1 Z-6. F300.\nG0 X0\nZ-1.\nY70.\nG1 Z-6.\n" + later), IsEmpty()) << "lifted a little";
    EXPECT_THAT(rapid("M98 P77\nG90 G17 G21 G54 G0 X0 Y-20. Z2.\nZ-6.\nY70.\n" + later), IsEmpty())
        << "who knows what that has cut";
    EXPECT_THAT(rapid("G90 G17 G21 G54 G0 X0 Y-20. Z2.\nZ-6.\nY70.\n" + later), ElementsAre(6));
    EXPECT_THAT(rapid("G1 Z-6. F300.\nG1 X0\nY70.\nG0 Y-20.\n" + later), IsEmpty()) << "back on its way";
}

TEST(RapidThroughWork, GoesOnWhereALessDeepCutWas) {
    const std::string first = "G0 Z-4.\nG1 X100. F300.\nG0 Z5.\nX-20.\n";
    EXPECT_THAT(rapid(first + "Z-8.\nX40.\nG1 X100.\nG0 Z50.\n"), ElementsAre(9));
    EXPECT_THAT(rapid(first + "Z-4.\nX40.\nG1 X100.\nG0 Z50.\n"), IsEmpty());
    EXPECT_THAT(rapid(first + "Z-8.\nG1 X100.\nG0 X40.\nZ50.\n"), IsEmpty());
    EXPECT_THAT(rapid(first + "T2 M6\nG0 X-20. Y-20.\nG43 H2 Z5.\nZ-8.\nX40.\nG0 Z50.\n"), IsEmpty());
}

TEST(RapidThroughWork, IsNotClaimedWhereAProgramMovesRapidlyAtDepthsAllTheTime) {
    const auto many = [](int moves) {
        std::string blocks;
        for (int i = 0; i < moves; ++i) blocks += "G0 Z2.\nX-90. Y" + std::to_string(i) + ".\nZ-1.\nX-80.\n";
        blocks += "G0 Z5.\nX-20. Y-20.\nG1 Z-6. F300.\nG0 X0\nY70.\nG1 X90. F500.\nY0\nX-20.\nG0 Z50.\n";
        return rapid(blocks).size();
    };
    EXPECT_EQ(many(90), 1U);
    EXPECT_EQ(many(100), 0U);
}

TEST(RapidThroughWork, KnowsArcsByTheirWay) {
    EXPECT_THAT(rapid("G1 Z-6. F300.\nG2 X20. Y-20. R20.\nG0 X-20.\nG1 Y20.\nX0\nY-40.\nG0 Z50.\n"),
                ElementsAre(6));
    EXPECT_THAT(rapid("G1 Z-6. F300.\nG2 X20. Y-20. R20.\nG0 X-20.\nG1 Y20.\nX0\nY-10.\nG0 Z50.\n"),
                IsEmpty());
}

// ---- MAC585

TEST(FeedUnderRapid, StandsBesideAnEndPointAndWithoutG0) {
    const auto feed = [](const std::string& blocks) {
        return lines_raised("MAC585", "O9585\nG17 G21 G90 G54 G0 X10. Y30.\n" + blocks + "\nM30\n");
    };
    EXPECT_THAT(feed("Z-5. F200."), ElementsAre(3));
    EXPECT_THAT(feed("G0 Z-5. F200."), IsEmpty());
    EXPECT_THAT(feed("G31 Z-5. F200."), IsEmpty());
    EXPECT_THAT(feed("M165 P9810 Z-5. F200."), IsEmpty());
    EXPECT_THAT(feed("Z5. F200."), IsEmpty()) << "above the work";
    EXPECT_THAT(feed("F200."), IsEmpty());
    EXPECT_THAT(feed("G1 Z-5. F200."), IsEmpty());
    EXPECT_THAT(feed("G98 G81 Z-5. R2. F200.\nX50. F100.\nG80"), IsEmpty());
    EXPECT_THAT(feed("G65 P9100 Z-5. F200."), IsEmpty());
    EXPECT_THAT(feed("G66 P9100 A1.\nX5. F200.\nG67"), IsEmpty());
}

// ---- MAC510

TEST(CompensationWithoutMove, EndsBeforeTheToolHasMoved) {
    const auto never = [](const std::string& blocks) {
        return lines_raised("MAC510", "O9510\nG17 G21 G90 G40 G0 X10. Y30.\n" + blocks + "M30\n");
    };
    EXPECT_THAT(never("G41 D1\nG1 Z-5. F200.\nG40\n"), ElementsAre(3));
    EXPECT_THAT(never("G41 D1\nG1 Z-5. F200.\nT2 M6\nX5.\nG40\n"), IsEmpty()) << "MAC521";
    EXPECT_THAT(never("G1 G41 D1 X5. F200.\nG40\n"), IsEmpty());
    EXPECT_THAT(never("G41 D1\nX#1\nG40\n"), IsEmpty());
    EXPECT_THAT(never("G41 D1\nM98 P77\nG40\n"), IsEmpty());
    EXPECT_THAT(never("G41 D1\nG1 X5. F200.\nG40\nG0 Z50.\n"), IsEmpty()) << "G40 alone is a habit";
    EXPECT_THAT(never("G41 D1\n"), IsEmpty()) << "for who calls it";
}

// ---- MAC513

std::vector<std::string> standing(const std::string& blocks, const std::string& control) {
    cli::Overrides overrides;
    overrides.control = control;
    overrides.select = {"MAC513"};
    const std::string text =
        "O9513\nG17 G21 G90 G40 G0 X-20. Y-20.\nG41 D1 G1 X0 F200.\n" + blocks + "G40 Y-20.\nM30\n";
    std::vector<std::string> lines;
    for (const auto& [finding, suppressed] : test::lint_texts({{"O1.nc", text}}, overrides).findings)
        lines.push_back(std::to_string(finding.source->position(finding.span.begin).line));
    return lines;
}

TEST(BlocksWithoutAMove, AreTooManyForTheControl) {
    EXPECT_THAT(standing("Y40.\nM8\nG4 P500\nX60.\n", "fanuc-16i"), ElementsAre("6"));
    EXPECT_THAT(standing("Y40.\nM8\nG4 P500\nX60.\n", "fanuc-30i"), IsEmpty());
    EXPECT_THAT(standing("Y40.\nM8\nG4 P500\nZ-6.\nX60.\n", "fanuc-30i"), ElementsAre("7"));
    EXPECT_THAT(standing("Y40.\nM8\nG4 P500\nZ-6.\nX60.\n", "haas"), IsEmpty());
    EXPECT_THAT(standing("Y40.\nM8\nX60.\nM9\nY0\n", "fanuc-16i"), IsEmpty());
    EXPECT_THAT(standing("M8\nG4 P500\nY40.\nX60.\n", "fanuc-16i"), IsEmpty()) << "on the way to the path";
    EXPECT_THAT(standing("Y40.\nM8\n(WATER)\n\nX60.\n", "fanuc-16i"), IsEmpty());
    EXPECT_THAT(standing("Y40.\nM8\nM98 P77\nM9\nX60.\n", "fanuc-16i"), IsEmpty());
}

// ---- MAC535

std::vector<std::uint32_t> plane_changed(const std::string& blocks) {
    return lines_raised("MAC535", "O9535\nG21 G17 G90 G40 G0 X-20. Y-20.\n" + blocks + "M30\n");
}

TEST(PlaneUnderCompensation, Changes) {
    const std::string on = "G41 D1 G1 X0 F200.\n", off = "G40 Y-20.\n";
    EXPECT_THAT(plane_changed(on + "Y40.\nG18\nX60.\n" + off), ElementsAre(5));
    EXPECT_THAT(plane_changed(on + "Y40.\nG18 X60.\nG19 Y0\n" + off), ElementsAre(5)) << "once";
    EXPECT_THAT(plane_changed(on + "Y40.\nG17\nX60.\n" + off), IsEmpty()) << "it is the same";
    EXPECT_THAT(plane_changed(on + "Y40.\n" + off + "G18\n"), IsEmpty());
    EXPECT_THAT(plane_changed(on + "Y40.\nG40 G18 X60.\n"), IsEmpty()) << "it ends there";
    EXPECT_THAT(plane_changed("G18\n" + on + "X40.\nG40 X60.\nG17\n"), IsEmpty());
    EXPECT_THAT(plane_changed("IF[#500EQ1]GOTO5\n" + on + "N5 G18\n" + off), IsEmpty()) << "on some paths";
    EXPECT_THAT(plane_changed(on + "M98 P77\nG18\n" + off), IsEmpty()) << "who knows what that does";
    EXPECT_THAT(lines_raised("MAC535", "O9535\nG41 D1 G1 X0 F200.\nY40.\nG18\n" + off + "M99\n"), IsEmpty())
        << "which plane it was the caller knows";
}

} // namespace
} // namespace maclint
