//! Rules that ask which modal codes are in force at a block: MAC511, MAC569.
#include "analyzer/program/tables.hpp"
#include "rules/rule.hpp"
#include "tests/rules/raised.hpp"
#include "tests/support/analysed.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using test::judged;
using test::lines_raised;
using test::messages_raised;
using test::path_raised;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// ---- MAC511

/// Of a program whose compensation is off, from its third line on.
std::vector<std::uint32_t> on_an_arc(const std::string& blocks) {
    return lines_raised("MAC511", "O9511\nG17G90G40G0X0Y0\n" + blocks + "M30\n");
}

TEST(CompensationOnAnArc, MayNotStartInOne) {
    EXPECT_THAT(on_an_arc("G41D1G3X20.R10.F200.\n"), ElementsAre(3));
    EXPECT_THAT(on_an_arc("G3X20.R10.F200.\nG42D1X0R10.\n"), ElementsAre(4)); // the motion mode of line 3
    EXPECT_THAT(on_an_arc("G41D#1G2X#2Y0R10.F200.\n"), ElementsAre(3));
    EXPECT_THAT(on_an_arc("G2X20.R10.F200.\n#1=5\nG42D#1X#2R10.\n"), ElementsAre(5));
    EXPECT_THAT(on_an_arc("G41D1X20.F200.\nG3X40.R10.\n"), IsEmpty());
    EXPECT_THAT(on_an_arc("G3X20.R10.F200.\nG41D1G1X30.\nG3X40.R10.\n"), IsEmpty());
}

TEST(CompensationOnAnArc, MayNotEndInOne) {
    const std::string on = "G41D1G1X20.F200.\n";
    EXPECT_THAT(on_an_arc(on + "G3X40.R10.\nG40X60.R10.\n"), ElementsAre(5));
    EXPECT_THAT(on_an_arc(on + "G40G3X40.R10.\n"), ElementsAre(4));
    EXPECT_THAT(on_an_arc(on + "G3X40.R10.\nG40G1X60.\n"), IsEmpty());
    EXPECT_THAT(on_an_arc("G40G3X40.R10.F200.\n"), IsEmpty()); // it is off
}

TEST(CompensationOnAnArc, IsSwitchedOverOnlyWithAWarning) {
    const std::string text =
        "O9511\nG17G90G40G0X0Y0\nG41D1G1X20.F200.\nG42G3X40.R10.\nG41X60.\nG40G1X0\nM30\n";
    EXPECT_THAT(judged("MAC511", text), ElementsAre("warning 4", "warning 5"));
    EXPECT_THAT(messages_raised("MAC511", text)[0],
                testing::AllOf(HasSubstr("'G42'"), HasSubstr("G3 "), testing::Not(HasSubstr("034"))));
    EXPECT_THAT(on_an_arc("G41D1G1X20.F200.\nG41G3X40.R10.\n"), IsEmpty());
}

TEST(CompensationOnAnArc, NamesTheAlarm) {
    const auto messages =
        messages_raised("MAC511", "O9511\nG40G17\nG41D1G3X20.R10.F200.\nG1Y20.\nG40X0\nM30\n");
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_THAT(messages[0], testing::AllOf(HasSubstr("switched on"), HasSubstr("alarm 034")));
}

TEST(CompensationOnAnArc, NeedsAMove) {
    EXPECT_THAT(on_an_arc("G3X20.R10.F200.\nG41D1\nG1X30.\n"), IsEmpty());
    EXPECT_THAT(on_an_arc("G41D1G1X20.F200.\nG3X40.R10.\nG40\nG1X50.\n"), IsEmpty());
}

TEST(CompensationOnAnArc, IsNotClaimedWhereTheStateIsNotKnown) {
    EXPECT_THAT(lines_raised("MAC511", "O9511\nG41D1G3X20.R10.F200.\nG1X0\nM99\n"), IsEmpty());
    EXPECT_THAT(on_an_arc("M98P77\nG41D1G3X20.R10.F200.\n"), IsEmpty());
    EXPECT_THAT(on_an_arc("G3X20.R10.F200.\nIF[#1EQ1]GOTO5\nG1\nN5G41D1X40.R10.\n"), IsEmpty());
    EXPECT_THAT(on_an_arc("G3X20.R10.F200.\nG#1\nG41D1X40.R10.\n"), IsEmpty());
    EXPECT_THAT(on_an_arc("GOTO5\nG41D1G3X20.R10.F200.\nN5\n"), IsEmpty());
    EXPECT_THAT(on_an_arc("G41G40D1G3X20.R10.F200.\n"), IsEmpty());
    EXPECT_THAT(on_an_arc("G40G41D1G3X20.R10.F200.\n"), IsEmpty());
}

TEST(CompensationOnAnArc, IsClaimedInASubprogramThatSwitchesOffItself) {
    EXPECT_THAT(lines_raised("MAC511", "O9511\nG41D1G3X20.R10.F200.\nG40G1X0\nM99\n"), ElementsAre(2));
    // The circle of an earlier block goes on only on some path, and the caller's is not known.
    EXPECT_THAT(lines_raised("MAC511", "O9511\nG41D1X20.R10.F200.\nG40G1X0\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC511", "O9511\nM98P77\nG41D1G3X20.R10.F200.\nG40G1X0\nM99\n"), IsEmpty());
}

TEST(CompensationOnAnArc, IsNotClaimedWhereAnotherCodeSaysHowToMove) {
    EXPECT_THAT(on_an_arc("G3X20.R10.F200.\nG41D1G31X30.\n"), IsEmpty());
    EXPECT_THAT(on_an_arc("G3X20.R10.F200.\nG41D1G28X30.\n"), IsEmpty());
    EXPECT_THAT(on_an_arc("G3X20.R10.F200.\nG41D1G81X30.Z-5.R1.\n"), IsEmpty());
    EXPECT_THAT(on_an_arc("G3X20.R10.F200.\nG41D1G54X30.R10.\n"), ElementsAre(4));
}

TEST(CompensationOnAnArc, ShowsWhatIsInForce) {
    EXPECT_THAT(path_raised("MAC511", "O9511\nG40G17\nG3X20.R10.F200.\n#1=1\nG42D#1X0R10.\nM30\n"),
                ElementsAre(3, 5));
    EXPECT_THAT(path_raised("MAC511", "O9511\nG41D1G1X9.\nG1X20.\n#1=1\nG40G3X#1R10.\nM30\n"),
                ElementsAre(2, 5));
}

std::vector<std::uint32_t> raised_in_din_plus(std::string_view code, const std::string& text) {
    const auto workspace = test::analyse_text("dinplus", text);
    std::vector<std::uint32_t> lines;
    for (const Finding& finding : run_rules(*workspace, {{find_rule(code)}}, 1))
        lines.push_back(finding.source->position(finding.span.begin).line);
    return lines;
}

TEST(CompensationOnAnArc, IsAFaultInDinPlusToo) {
    const std::string begin = "MACHINING\nN1 T2\nN2 G0 X18 Z3\nN3 G42\nN4 G1 Z-30\n";
    EXPECT_THAT(raised_in_din_plus("MAC511", begin + "N5 G40 G2 X36 Z-40 R10\nN6 M30\nEND\n"),
                ElementsAre(6));
    EXPECT_THAT(raised_in_din_plus("MAC511", begin + "N5 G40 G13 X36 Z-40 R10\nN6 M30\nEND\n"),
                ElementsAre(6));
    EXPECT_THAT(raised_in_din_plus("MAC511", begin + "N5 G2 X36 Z-40 R10\nN6 G40\nN7 G0 X50\nN8 M30\nEND\n"),
                IsEmpty());
    EXPECT_THAT(raised_in_din_plus("MAC511", begin + "N5 G40 G0 X36\nN6 M30\nEND\n"), IsEmpty());
}

// ---- MAC569

/// Of a program that begins a cycle in its second line.
std::vector<std::uint32_t> left_in_force(const std::string& blocks) {
    return lines_raised("MAC569", "O9569\nG98G81X1.Y1.Z-5.R2.F100.\n" + blocks + "G80\nM30\n");
}

TEST(CycleAtAToolChange, IsStillInForce) {
    EXPECT_THAT(left_in_force("X2.\nT2M6\n"), ElementsAre(4));
    EXPECT_THAT(left_in_force("G91G28Z0\n"), ElementsAre(3));
    EXPECT_THAT(left_in_force("G30Z0\n"), ElementsAre(3));
    EXPECT_THAT(left_in_force("G27X0Y0\n"), ElementsAre(3));
    EXPECT_THAT(left_in_force("G53Z0\n"), IsEmpty());
}

TEST(CycleAtAToolChange, IsOffAfterItsEnd) {
    EXPECT_THAT(left_in_force("G80\nT2M6\n"), IsEmpty());
    EXPECT_THAT(left_in_force("G80T2M6\n"), IsEmpty());
    EXPECT_THAT(left_in_force("G80G91G28Z0\n"), IsEmpty());
    EXPECT_THAT(left_in_force("G0Z50.\nT2M6\n"), IsEmpty()); // a motion code ends it as well
    EXPECT_THAT(left_in_force("G0Z#1\nT2M6\n"), IsEmpty());
    EXPECT_THAT(left_in_force("#1=5\nG80\nT#1M6\n"), IsEmpty());
}

TEST(CycleAtAToolChange, IsReportedOnceForEachThatIsBegun) {
    EXPECT_THAT(left_in_force("G28Z0\nT2M6\n"), ElementsAre(3));
    EXPECT_THAT(left_in_force("G28Z0\nG80\nG81X2.Z-5.R2.\nT2M6\n"), ElementsAre(3, 6));
}

TEST(CycleAtAToolChange, NeedsAPathOnWhichItStays) {
    EXPECT_THAT(left_in_force("IF[#500EQ1]GOTO5\nG80\nN5T2M6\n"), ElementsAre(5));
    EXPECT_THAT(left_in_force("IF[#500EQ1]GOTO5\nG80\nN5IF[#500NE1]GOTO6\nG80\nN6T2M6\n"), IsEmpty());
    EXPECT_THAT(path_raised("MAC569", "O9569\nG81X1.Z-5.R2.\nIF[#500EQ1]GOTO5\nG80\nN5T2M6\nM30\n"),
                ElementsAre(2, 3, 5));
}

TEST(CycleAtAToolChange, IsNotClaimedWhereItMayHaveEnded) {
    EXPECT_THAT(left_in_force("M98P77\nT2M6\n"), IsEmpty());
    EXPECT_THAT(left_in_force("G#1\nT2M6\n"), IsEmpty());
    EXPECT_THAT(left_in_force("G#1T2M6\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC569", "O9569\nT2M6\nG28Z0\nM99\n"), IsEmpty()); // the caller's
    EXPECT_THAT(left_in_force("GOTO5\nT2M6\nN5\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC569", "O9569\nG66P9010\nX1.\nT2M6\nG67\nM30\n"), IsEmpty()); // MAC413
}

TEST(CycleAtAToolChange, IsFollowedThroughCalls) {
    EXPECT_THAT(left_in_force("M98P9570\nT2M6\nG80\nM30\nO9570\nX5.\nX6.\nM99\nO9571\n"), ElementsAre(4));
    EXPECT_THAT(left_in_force("M98P9570\nT2M6\nG80\nM30\nO9570\nX5.\nG80\nM99\nO9571\n"), IsEmpty());
    EXPECT_THAT(left_in_force("M98P9570\nT2M6\nG80\nM30\nO9570\nG0X5.\nM99\nO9571\n"), IsEmpty());
}

TEST(CycleAtAToolChange, IsSeenAtAToolOfALathe) {
    const std::string begin = "O9569\nG50S2000\nT0101\nG96S150M3\nG0X0Z2.\nG83Z-20.Q5000F0.1\n";
    EXPECT_THAT(lines_raised("MAC569", begin + "T0202\nG80\nG28U0W0\nM30\n"), ElementsAre(7));
    EXPECT_THAT(lines_raised("MAC569", begin + "G80\nT0202\nG28U0W0\nM30\n"), IsEmpty());
}

} // namespace
} // namespace maclint
