//! What the examples of the rules on the machine's state cannot show: evidence, and who calls whom.
#include "tests/rules/raised.hpp"
#include "tests/support/linted.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using test::judged;
using test::lines_raised;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

const std::string begins = "O1\nG90 G17 G54 G40\nT1 M6\n"; // three lines

TEST(SpindleMissing, SpeaksOfTheBlockInWhichTheToolGoesDown) {
    const std::string before = begins + "S500\nG0 X0 Y0\nG43 H1 Z5.\n";
    EXPECT_THAT(lines_raised("MAC554", before + "G1 Z-5. F200.\nX50.\nY50.\nM30\n"), ElementsAre(7));
    EXPECT_THAT(lines_raised("MAC554", before + "G1 Z-5. F200.\nG0 Z5.\nM30\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC554", before + "G1 Z-5. F200.\nM0\nX50.\nM30\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC554", before + "M77\nG1 Z-5. F200.\nX50.\nM30\n"), IsEmpty());
}

TEST(SpindleMissing, FollowsTheCalls) {
    const std::string holes = "O2\nG81 X5. Y5. Z-3. R2. F100.\nG80\nM99\n";
    EXPECT_THAT(lines_raised("MAC554", begins + "S500\nG43 H1 Z5.\nM98 P2\nM30\n" + holes), ElementsAre(6));
    EXPECT_THAT(lines_raised("MAC554", begins + "S500 M3\nG43 H1 Z5.\nM98 P2\nM30\n" + holes), IsEmpty());
    EXPECT_THAT(lines_raised("MAC554", begins + "S500\nG43 H1 Z5.\nM98 P3\nM98 P2\nM30\n" + holes), IsEmpty())
        << "nobody has O3";
}

/// A tool that works, with what stands behind its work.
std::string tool(int number, const std::string& end, const std::string& start = "S900 M3\n") {
    const std::string n = std::to_string(number);
    return "T" + n + " M6\n" + start + "G43 H" + n + " Z50.\nG1 Z-5. F200.\nG0 Z50.\n" + end;
}

TEST(LeftOn, IsToldWhereEachOtherToolStops) {
    const std::string head = "O1\nG90 G17 G54\n";
    const std::string off = "M5\n";
    EXPECT_THAT(
        lines_raised("MAC563", head + tool(1, off) + tool(2, off) + tool(3, "") + tool(4, off) + "M30\n"),
        ElementsAre(20));
    EXPECT_THAT(lines_raised("MAC563", head + tool(1, "") + tool(2, off) + tool(3, off) + tool(4, "") +
                                           tool(5, off) + "M30\n"),
                IsEmpty())
        << "twice";
    EXPECT_THAT(lines_raised("MAC563", head + tool(1, off) + tool(2, "") + tool(3, off) + "M30\n"), IsEmpty())
        << "once each way";
    EXPECT_THAT(lines_raised("MAC563", head + tool(1, off) + tool(2, off) + tool(3, "", "S900\nM98 P2\n") +
                                           tool(4, off) + "M30\nO2\nM3\nM99\n"),
                IsEmpty())
        << "a program that is called has started it";
}

TEST(FeedMissing, FollowsTheCalls) {
    const std::string slot = "O2\nG91 G1 X5.\nG90\nM99\n";
    EXPECT_THAT(lines_raised("MAC553", begins + "S500 M3\nG43 H1 Z5.\nM98 P2\nM30\n" + slot), ElementsAre(6));
    EXPECT_THAT(lines_raised("MAC553", begins + "S500 M3 F200.\nG43 H1 Z5.\nM98 P2\nM30\n" + slot),
                IsEmpty());
}

TEST(FeedMissing, TakesTheLastWordOfABlock) {
    EXPECT_THAT(lines_raised("MAC553", begins + "S500 M3\nG1 Z-5. F0 F200.\nM30\n"), IsEmpty());
}

TEST(OffsetOfAnotherTool, LeavesToolsWithSeveralOffsetsAlone) {
    const std::string others = "T2 M6\nG43 H2 Z50.\nT3 M6\nG43 H3 Z50.\n";
    EXPECT_THAT(lines_raised("MAC520", begins + "G43 H2 Z50.\n" + others + "M30\n"), ElementsAre(4));
    EXPECT_THAT(lines_raised("MAC520", begins + "G43 H1 Z50.\nG43 H21 Z5.\n" + others + "M30\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC520", begins + "G43 H2 Z50.\nM30\n"), IsEmpty())
        << "nothing to hold it against";
}

TEST(LengthOffsetMissing, KnowsThatAPathLeavesItOut) {
    const std::string other = "T2 M6\nG43 H2 Z50.\n";
    EXPECT_THAT(lines_raised("MAC568", begins + "G0 Z50.\n" + other + "M30\n"), ElementsAre(4));
    EXPECT_THAT(lines_raised("MAC568", begins + "G91 G28 Z0\nG90\n" + other + "M30\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC568", begins + "G53 Z0\n" + other + "M30\n"), IsEmpty());
}

TEST(LengthOffsetMissing, KnowsThatAPathLeadsAroundTheChoice) {
    const std::string other = "T2 M6\nG43 H2 Z50.\n";
    EXPECT_THAT(lines_raised("MAC568", begins + "/ G43 H1 Z50.\nG0 Z5.\n" + other + "M30\n"), ElementsAre(5));
    EXPECT_THAT(lines_raised("MAC568", begins + "/ G43 H1\nG0 Z5.\nZ2.\n" + other + "M30\n"), ElementsAre(5));
    EXPECT_THAT(
        lines_raised("MAC568", begins + "IF[#500EQ1]GOTO9\nG43 H1 Z50.\nN9 G0 Z5.\n" + other + "M30\n"),
        ElementsAre(6));
    EXPECT_THAT(lines_raised("MAC568", begins +
                                           "IF[#500EQ1]GOTO9\nG43 H1 Z50.\nN9 G0 X5.\nIF[#500EQ1]GOTO8\n"
                                           "Z5.\nN8\n" +
                                           other + "M30\n"),
                IsEmpty())
        << "not on the path that leaves it out";
    EXPECT_THAT(lines_raised("MAC568", begins +
                                           "IF[#500EQ1]GOTO8\nG43 H1 Z50.\nGOTO9\nN8 G43 H11 Z50.\n"
                                           "N9 G0 Z5.\n" +
                                           other + "M30\n"),
                IsEmpty());
    EXPECT_THAT(lines_raised("MAC568", begins + "/ G43 H1 Z50.\nG43 H1\nG0 Z5.\n" + other + "M30\n"),
                IsEmpty());
    EXPECT_THAT(lines_raised("MAC568", begins + "/ G43 H1 Z50.\nG0 Z5.\nM30\n"), IsEmpty())
        << "no other tool";
    EXPECT_THAT(lines_raised("MAC568", begins + "/ G43 H1 Z50.\nM98 P9000\nG0 Z5.\n" + other + "M30\n"),
                IsEmpty())
        << "nobody has O9000";
}

TEST(ModeKeptAcrossChange, IsOneThatTheProgramEndsElsewhere) {
    const std::string slot = "G68 X0 Y0 R30.\nG0 X20. Y0\nG1 Z-2. F200.\nG0 Z50.\n";
    const std::string next = "T2 M6\nG43 H2 Z50.\nG0 X5. Y5.\n";
    EXPECT_THAT(lines_raised("MAC531", begins + slot + "G69\n" + slot + next + "G69\nM30\n"),
                ElementsAre(15));
    EXPECT_THAT(lines_raised("MAC531", begins + slot + next + "G69\nM30\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC531", begins + slot + "G69\n" + slot + next + "T3 M6\nX5.\nG69\n" + slot +
                                           next + "G69\nM30\n"),
                IsEmpty())
        << "the habit is to keep it";
    EXPECT_THAT(
        lines_raised("MAC531", begins + slot + "G69\n" + slot + "T2 M6\nG43 H2 Z50.\nG69\nX5.\nM30\n"),
        IsEmpty())
        << "it ends before the next tool moves";
}

TEST(ModeKeptAcrossChange, LetsAShiftBeGivenAgain) {
    const std::string first = begins + "G52 X10. Y0\nG0 X0 Y0\n";
    EXPECT_THAT(lines_raised("MAC531", first + "G55 X0\nG52 X0 Y0\nM30\n"), ElementsAre(6));
    EXPECT_THAT(lines_raised("MAC531", first + "G55\nG52 X20. Y0\nG0 X0\nG52 X0 Y0\nM30\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC531", first + "G55 X0\nG56 X0\nG52 X0 Y0\nM30\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC531", first + "G55 X0\nM30\n"), IsEmpty()) << "MAC502 says it";
    EXPECT_THAT(lines_raised("MAC531", first + "G54 X0\nG52 X0 Y0\nM30\n"), IsEmpty()) << "the same";
}

TEST(TransformCancelOrder, IsAboutWhatBeganInside) {
    const std::string turned = "G68 X0 Y0 R15.\nG43 H1 Z20.\nG1 Z-2. F100.\nG0 Z20.\n";
    EXPECT_THAT(lines_raised("MAC509", begins + turned + "G69\nG49 Z200.\nM30\n"), ElementsAre(8));
    EXPECT_THAT(lines_raised("MAC509", begins + turned + "G49 Z200.\nG69\nM30\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC509", begins + turned + "G69\nM30\n"), IsEmpty()) << "nothing is ended";
    EXPECT_THAT(
        lines_raised("MAC509", begins + "G43 H1\n" + turned.substr(0, 15) + "G1 X5. F100.\nG69\nG49\nM30\n"),
        IsEmpty());
    const std::string shifted = begins + "G43 H1 Z5.\nG52 X40. Y10.\nG68 X0 Y0 R15.\nG0 X5.\n";
    EXPECT_THAT(lines_raised("MAC509", shifted + "G52 X0 Y0\nG0 X0 Y0\nX5.\nG69\nM30\n"), ElementsAre(9));
    EXPECT_THAT(lines_raised("MAC509", shifted + "G52 X0 Y0\nG0 Z50.\nG69\nX5.\nM30\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC509", shifted + "G69\nG52 X0 Y0\nX5.\nM30\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC509", begins +
                                           "G43 H1 Z5.\nG68 X0 Y0 R15.\nG52 X40. Y10.\nG0 X5.\nG52 X0 Y0\n"
                                           "X0\nG69\nM30\n"),
                IsEmpty())
        << "the shift lies in the rotation";
}

TEST(IncrementalAfterReference, LetsTheTableComeForward) {
    const std::string home = begins + "S500 M3\nG43 H1 Z5.\nG91 G28 Z0\n";
    EXPECT_THAT(lines_raised("MAC524", home + "T2 M6\nG0 X25. Y25.\nM30\n"), ElementsAre(8));
    EXPECT_THAT(lines_raised("MAC524", home + "G0 Y200.\nM30\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC524", home + "T2 M6\nG91 G0 X25. Y25.\nM30\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC524", home + "T2 M6\nG90 G0 X25. Y25.\nM30\n"), IsEmpty());
}

TEST(ReturnThroughZero, IsOneThatGoesDown) {
    const std::string above = begins + "S500 M3\nG43 H1 Z50.\nG1 Z-5. F200.\nG0 Z50.\n";
    EXPECT_THAT(lines_raised("MAC567", above + "G28 Z0\nM30\n"), ElementsAre(8));
    EXPECT_THAT(lines_raised("MAC567", above + "G28 Z100.\nM30\n"), IsEmpty());
    // From below it comes out of the work: told, since nothing but the place keeps it from going in.
    EXPECT_THAT(judged("MAC567", above + "G1 Z-5.\nG28 Z0\nM30\n"), ElementsAre("note 9"));
    EXPECT_THAT(judged("MAC567", above + "G28 Z0\nM30\n"), ElementsAre("warning 8"));
    EXPECT_THAT(lines_raised("MAC567", above + "G91 G28 Z0\nM30\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC567", above + "G28 X0 Y0\nM30\n"), IsEmpty());
}

TEST(TappingOrder, IsTheCyclesAndNotTheChipConveyors) {
    const std::string before = begins + "G43 H1 Z50.\nM29 S500\n";
    EXPECT_THAT(lines_raised("MAC530", before + "X10.\nG84 X10. Z-10. R5. F500.\nG80\nM30\n"),
                ElementsAre(7));
    EXPECT_THAT(lines_raised("MAC530", before + "G84 X10. Z-10. R5. F500.\nG80\nM29\nX10.\nM30\n"),
                IsEmpty());
    EXPECT_THAT(lines_raised("MAC530", before + "X10.\nT2 M6\nG84 X10. Z-10. R5. F500.\nG80\nM30\n"),
                IsEmpty());
}

} // namespace
} // namespace maclint
