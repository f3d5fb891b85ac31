//! What rules find in SINUMERIK programs that run parts of themselves again.
#include "rules/rule.hpp"
#include "tests/support/analysed.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

std::vector<Finding> told(std::string_view code, const std::string& text) {
    return run_rules(*test::analyse_text("sinumerik", "G17 G90 G54 G94 F100\n" + text), {{find_rule(code)}},
                     1);
}

/// Behind a part that is repeated, an arc that can be none.
std::vector<Finding> arcs_behind(const std::string& text) {
    return told("MAC522", text + "\nG0 X0 Y0\nG2 X10 Y10 CR=2\nM30\n");
}

TEST(SinumerikParts, LeaveModesThatTheyDoNotSet) {
    EXPECT_THAT(arcs_behind("G0 X0\nROW: G91 G1 X5\nG90\nREPEAT ROW P=3"), SizeIs(1));
    EXPECT_THAT(arcs_behind("ROW: G0 X0\nROW_END: G1 X5\nM8\nREPEAT ROW ROW_END"), SizeIs(1));
    EXPECT_THAT(arcs_behind("ROW: G0 X0\nROW_END: G1 X5\nM8\nCALL BLOCK ROW TO ROW_END"), SizeIs(1));
    EXPECT_THAT(arcs_behind("ROW: G0 X0\nM8\nREPEATB ROW P=2"), SizeIs(1));
    EXPECT_THAT(
        arcs_behind("ROW:\nFOR R1=0 TO 5\nG1 X=R1\nENDFOR\nROW_END: G0 X0\nG4 F1\nREPEAT ROW ROW_END"),
        SizeIs(1));
}

TEST(SinumerikParts, SetWhatTheirLastWordSets) {
    const std::string part = "ROW: G91\nROW_END: G1 X3\nG90 G0 X0 Y0\n";
    EXPECT_THAT(told("MAC522", part + "REPEAT ROW ROW_END\nG90 G0 X0 Y0\nG2 X10 Y10 CR=2\nM30\n"), SizeIs(1));
    // Under G91 nobody knows where the arc begins.
    EXPECT_THAT(told("MAC522", part + "REPEAT ROW ROW_END\nX0 Y0\nG2 X10 Y10 CR=2\nM30\n"), SizeIs(1));
    const std::string shifted = "ROW: TRANS X10\nROW_END: G0 X5\nTRANS\n";
    EXPECT_THAT(told("MAC502", shifted + "REPEAT ROW ROW_END\nG0 X9\nM30\n"), SizeIs(1));
    EXPECT_THAT(told("MAC502", shifted + "REPEAT ROW ROW_END\nTRANS\nG0 X9\nM30\n"), IsEmpty());
    // How often it runs is not known, perhaps never.
    EXPECT_THAT(told("MAC502", shifted + "REPEAT ROW ROW_END P=R1\nG0 X9\nM30\n"), IsEmpty());
}

TEST(SinumerikParts, MayDoAnythingWithAProgramInThem) {
    EXPECT_THAT(arcs_behind("ROW: POCKET\nROW_END: G0 X5\nG18\nG17\nREPEAT ROW ROW_END"), IsEmpty());
    EXPECT_THAT(arcs_behind("ROW: G0 X5\nROW_END: GOTOF NEXT\nNEXT: M8\nREPEAT ROW ROW_END"), IsEmpty());
    EXPECT_THAT(told("MAC522",
                     "REPEAT ROW ROW_END\nG0 X0 Y0\nG2 X10 Y10 CR=2\nM30\nROW: G0 X0\nREPEATB SMALL\n"
                     "ROW_END: X5\nSMALL: G91\n"),
                IsEmpty());
    EXPECT_THAT(arcs_behind("M8\nREPEAT ROW"), IsEmpty());            // there is no such part
    EXPECT_THAT(arcs_behind("N40 G0 X5\nM8\nREPEAT N40"), IsEmpty()); // numbers are not looked for
    EXPECT_THAT(arcs_behind("ROW: G0 X5\nREPEAT ROW ROW_END\nROW_END: M8"), IsEmpty());
}

TEST(SinumerikParts, AreJudgedOnceWhereTheyStand) {
    const std::string arc = "ROW: G0 X0 Y0\nG2 X40 Y0 CR=3\nROW_END: G0 X0\n";
    EXPECT_THAT(told("MAC522", arc + "M8\nREPEAT ROW ROW_END P=4\nM9\nREPEAT ROW ROW_END\nM30\n"), SizeIs(1));
    EXPECT_THAT(told("MAC522", "REPEAT ROW ROW_END\nM8\nREPEAT ROW ROW_END P=2\nM30\n" + arc), SizeIs(1));
}

TEST(SinumerikParts, BehindTheEndNeedNoEndOfTheirOwn) {
    const std::string text = "REPEAT ROW\nTRANS\nM30\nROW: TRANS X5\nG0 X0\nENDLABEL:\n";
    for (const char* code : {"MAC456", "MAC502", "MAC301", "MAC303"})
        EXPECT_THAT(told(code, text), IsEmpty()) << code;
}

TEST(SinumerikParts, ChangeTheVariablesThatTheyStore) {
    const auto divisions = [](const std::string& part) {
        return told("MAC702",
                    "R2=2\nGOTOF START\n" + part + "START: R1=2\nREPEAT ROW ROW_END\nG0 X=1/(R1-2)\nM30\n");
    };
    EXPECT_THAT(divisions("ROW: R2=R1\nROW_END: G0 X5\n"), SizeIs(1));
    EXPECT_THAT(divisions("ROW: R1=R1+1\nROW_END: G0 X5\n"), IsEmpty());
    EXPECT_THAT(divisions("ROW: R[R2]=R1+1\nROW_END: G0 X5\n"), IsEmpty());
    // What the part reads is no store in vain.
    EXPECT_THAT(told("MAC213", "DEF INT K_=1\nROW: G0 X=R[K_]\nK_=2\nREPEATB ROW\nK_=3\nREPEATB ROW\nM30\n"),
                IsEmpty());
    EXPECT_THAT(told("MAC213", "DEF INT DEPTH\nGOTOF START\nROW: G0 X=DEPTH\nSTART: DEPTH=2\n"
                               "REPEATB ROW\nDEPTH=3\nREPEATB ROW\nM30\n"),
                IsEmpty());
}

TEST(SinumerikParts, ThatEndWhereRepeatStandsAreLoops) {
    const auto divisions = [](const std::string& behind) {
        return told("MAC702", "DEF INT PASS_NO\nR1=2\nROW: G1 X5\nPASS_NO=PASS_NO+1\n" + behind + "M30\n");
    };
    EXPECT_THAT(divisions("REPEAT ROW P=3\nG0 X=1/(R1-2)\n"), SizeIs(1));
    EXPECT_THAT(divisions("REPEAT ROW P=3\nG0 X=1/(PASS_NO-1)\n"), IsEmpty());
    for (const char* code : {"MAC318", "MAC319", "MAC320", "MAC336", "MAC301"})
        EXPECT_THAT(told(code, "ROW: G1 X5\nREPEAT ROW P=3\nM30\n"), IsEmpty()) << code;
}

TEST(SinumerikParts, BeginBeforeTheyEnd) {
    const std::string labels = "ROW: G1 X5\nROW_END: G1 X6\n";
    const auto round = told("SIN305", labels + "REPEAT ROW_END ROW P=2\nM30\n");
    ASSERT_THAT(round, SizeIs(1));
    EXPECT_THAT(round.front().message(), HasSubstr("the end stands before 'ROW_END'"));
    EXPECT_THAT(told("SIN305", labels + "REPEAT ROW ROW_END\nREPEAT ROW ROW\nM30\n"), IsEmpty());
    EXPECT_THAT(told("SIN305", labels + "ROW: G1 X7\nREPEAT ROW_END ROW\nM30\n"), IsEmpty());
}

TEST(SinumerikParts, AreNoConditionsInPaths) {
    const auto left = told("MAC502", "ROW: G1 X5\nG41 X6\nREPEAT ROW P=2\nG0 Z5\nM30\n");
    ASSERT_THAT(left, SizeIs(1));
    std::string words;
    for (const auto* steps : {&left.front().path, &left.front().related})
        for (const RelatedLocation& step : *steps) words += step.text + "; ";
    EXPECT_THAT(words, HasSubstr("the program goes on"));
}

} // namespace
} // namespace maclint
