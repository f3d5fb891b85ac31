//! What SINUMERIK blocks become in the program model.
#include "analyzer/program/tables.hpp"
#include "tests/dialect/both_lanes.hpp"
#include "tests/dialect/reading.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// The blocks of a program and the irregularities, one a line. Remarks keep them from the plain lane.
std::string lower(std::string_view text) { return test::lower(test::read_as("sinumerik", "PART.SPF", text)); }

TEST(SinumerikWords, ACodeSetsItsGroupToTheNumberOfItsMember) {
    EXPECT_EQ(lower("N10 G18 G91 ; a remark"), "N10 plane=2; distance mode=2");
    EXPECT_EQ(lower("DIAMON"), "radius or diameter=2");
    EXPECT_EQ(lower("G01 X=R1"), "motion mode=2; values R1; move");
    EXPECT_EQ(lower("G4 F2 ;"), "");                        // of its block alone
    EXPECT_EQ(lower("G300"), lower("PCALL /_N_SPF_DIR/A")); // a macro of the machine: nobody knows
}

TEST(SinumerikWords, AxesMoveUnlessACodeTakesThem) {
    EXPECT_EQ(lower("X=IC(-3) ;"), "values " + lower("X=IC(-3) ;").substr(7));
    EXPECT_THAT(lower("X=IC(-3)"), HasSubstr("move"));
    EXPECT_THAT(lower("POS[X]=100"), HasSubstr("move"));
    EXPECT_THAT(lower("TRANS X=R1"), Not(HasSubstr("move")));
    EXPECT_THAT(lower("CR=R1"), Not(HasSubstr("move")));
}

TEST(SinumerikVariables, RParametersAreVariables) {
    EXPECT_EQ(lower("R1=5 R2=R1*2 R[10]=-R01 R[R3+1]=7"),
              "R1 := 5; R2 := multiply(R1, 2); R10 := negate(R1); #[add(R3, 1)] := 7");
    EXPECT_EQ(lower("R1=1.5EX-3 R2='H1F' R3=TRUE"), "R1 := 0.0015.; R2 := 31; R3 := 1");
}

TEST(SinumerikVariables, DefinedOnesAreTheProgramsOwn) {
    EXPECT_EQ(lower("PROC PART(REAL DEPTH, VAR INT STATE_)\nDEF REAL STEP=.5, WAY=DEPTH\nWAY=STEP+DEPTH"),
              "\nWAY := DEPTH\nWAY := add(STEP, DEPTH)");
}

TEST(SinumerikVariables, OthersAreTheMachines) {
    const std::string read = lower("R1=FEEDS");
    EXPECT_THAT(read, HasSubstr("R1 := machine"));
    EXPECT_EQ(read, lower("R1=feeds"));
    EXPECT_THAT(lower("DEF REAL LIST_[5]\nR1=LIST_[2]"), HasSubstr("R1 := machine"));
    EXPECT_THAT(lower("R1=$AA_IM[X]"), HasSubstr("R1 := machine"));
}

TEST(SinumerikVariables, GroupsAreReadAndSetByTheirNumbers) {
    EXPECT_EQ(lower("R1=$P_GG[14]\nG[14]=R1"), "R1 := modal(distance mode)\ndistance mode=R1");
}

TEST(SinumerikFlow, JumpsLookInTheirDirection) {
    EXPECT_EQ(lower("GOTOF NEXT"), "jump NEXT forward");
    EXPECT_EQ(lower("GOTOB N40"), "jump 40 backward");
    EXPECT_EQ(lower("GOTO \"NEXT\""), "jump NEXT forward-then-backward");
    EXPECT_EQ(lower("GOTOC NEXT"), "jump NEXT forward-then-backward if-there");
    EXPECT_EQ(lower("IF R1>5 GOTOF ONE IF R1<2 GOTOB TWO"),
              "if greater(R1, 5) {jump ONE forward}; if less(R1, 2) {jump TWO backward}");
    EXPECT_EQ(lower("CASE R1 OF 1 GOTOF ONE DEFAULT GOTOF TWO"),
              "if equal(R1, 1) {jump ONE forward}; jump TWO forward");
}

TEST(SinumerikFlow, LoopsAndBranchesPair) {
    EXPECT_EQ(lower("IF R1==1\nELSE\nENDIF"), "open choice equal(R1, 1)\nmiddle choice\nclose choice");
    EXPECT_EQ(lower("FOR R1=0 TO 10\nENDFOR"),
              "R1 := 0; open counting less-equal(R1, 10)\nR1 := add(R1, 1); close counting");
    EXPECT_EQ(lower("REPEAT\nUNTIL R4>50"), "open until\nclose until greater(R4, 50)");
    EXPECT_EQ(lower("WHILE R1<1\nENDWHILE\nLOOP\nENDLOOP"),
              "open while less(R1, 1)\nclose while\nopen endless\nclose endless");
}

TEST(SinumerikFlow, APartThatEndsAtRepeatIsALoopThatCounts) {
    EXPECT_EQ(lower("ROW: R1=1\nREPEAT ROW P=3"),
              "ROW: R1 := 1\nif less(REPEAT 1, 3) {REPEAT 1 := add(REPEAT 1, 1); jump ROW backward}; "
              "exchange in REPEAT 1");
    EXPECT_THAT(lower("ROW: R1=1\nREPEAT ROW"), HasSubstr("less(REPEAT 1, 1)"));
    for (const char* passes : {"P=R2", "P=COUNT_-1"})
        EXPECT_THAT(lower("DEF INT COUNT_\nROW: R1=1\nREPEATB ROW " + std::string(passes)),
                    HasSubstr("if machine"));
}

TEST(SinumerikFlow, APartThatStandsElsewhereDoesWhatItsBlocksDo) {
    EXPECT_EQ(lower("ROW: G18 R1=R2\nM8\nREPEATB ROW"),
              "ROW: plane=2; R1 := R2\n\nplane=2; exchange out R2 out R1 in R1");
    EXPECT_THAT(lower("REPEATB ROW\nM30\nROW: G18"),
                HasSubstr("{jump ROW forward-then-backward}; plane=2\nend\nROW: plane=2"));
    EXPECT_THAT(lower("ROW: OTHER\nM8\nREPEATB ROW"), HasSubstr("calls-or-returns"));
    EXPECT_THAT(lower("ROW: M6\nG0\nREPEATB ROW"), HasSubstr("unreadable"));
}

TEST(SinumerikCalls, ANameThatNoTableKnowsIsAProgram) {
    EXPECT_EQ(lower("POCKET(1,,R5) P3"), "call call of a subprogram POCKET 1>0=1 R5>2=R5 times 3");
    EXPECT_EQ(lower("L0123"), "call call of a subprogram L0123");
    EXPECT_EQ(lower("CALL \"SUB\""), "call call of a subprogram SUB");
    EXPECT_EQ(lower("MCALL DRILL\nMCALL"), "call MCALL DRILL\nmodal call=0");
    EXPECT_THAT(lower("CYCLE81(50,0,2,-20)"), HasSubstr("call call of a cycle CYCLE81"));
    EXPECT_EQ(lower("STOPRE"), "synchronise");
    EXPECT_EQ(lower("M17"), "return");
    EXPECT_EQ(lower("M30"), "end");
}

TEST(SinumerikCalls, AMacroStandsForItsWordsWhereItStandsAlone) {
    EXPECT_EQ(lower("DEFINE OIL AS G0 Z5\nOIL"), "\nmotion mode=1; move");
    EXPECT_EQ(lower("DEFINE OIL AS M7\nOIL"), "");
    for (const char* program : {"DEFINE OIL AS G0 Z=R1\nOIL", "DEFINE OIL AS G0 Z5\nOIL X5"})
        EXPECT_THAT(lower(program), HasSubstr("call")) << program;
    EXPECT_THAT(lower("M8"), Not(HasSubstr("call")));
}

TEST(SinumerikErrors, AreToldWithWhatToWrite) {
    EXPECT_THAT(lower("IF R1=1 GOTOF NEXT"), HasSubstr("R1==1"));
    EXPECT_THAT(lower("R1==5"), HasSubstr("R1=5"));
    EXPECT_THAT(lower("IF R1 EQ 2 GOTOF NEXT"), HasSubstr("=="));
    EXPECT_THAT(lower("IF R1==1 AND R2<>0 OR R3==2"), HasSubstr("(R1==1) AND (R2<>0) OR (R3==2)"));
    EXPECT_THAT(lower("IF (R1==1) AND R2"), Not(HasSubstr("!")));
    EXPECT_THAT(lower("X DEPTH"), HasSubstr("X= DEPTH"));
    EXPECT_THAT(lower("-------- measuring --------"), HasSubstr("remark-without-sign"));
    EXPECT_THAT(lower("G1 X10 (finish cut)"), HasSubstr("; finish cut"));
    EXPECT_THAT(lower("GOTOF END_:"), HasSubstr("colon-in-jump"));
    EXPECT_THAT(lower("R1=(R2+3"), HasSubstr("')' is missing"));
    EXPECT_THAT(lower("N10 G0 X0 N20 G1 X5"), HasSubstr("second-block 'N20'"));
    EXPECT_THAT(lower("ENDI"), HasSubstr("ENDIF"));
    EXPECT_THAT(lower("GOTFO NEXT"), HasSubstr("GOTOF"));
    EXPECT_THAT(lower("CASE R1 OF 1 GOTOF ONE DEFAULT TWO"), HasSubstr("a jump such as GOTOF"));
}

TEST(SinumerikErrors, WhatCannotBeReadMayDoWhatItNames) {
    EXPECT_THAT(lower("IF R1=(5\nENDIF"), HasSubstr("opens-or-closes"));
    EXPECT_THAT(lower("NEXT: R1=)"), HasSubstr("NEXT"));
}

TEST(SinumerikErrors, BlocksOfAnotherLanguageAreNotJudged) {
    const std::string text = lower("G291\nO1(X\nG65 P2 A#1\nG290\nR1=5");
    EXPECT_THAT(text, Not(HasSubstr("!")));
    EXPECT_THAT(text, HasSubstr("R1 := 5"));
}

TEST(SinumerikLanes, Agree) {
    constexpr std::string_view text = "N10 G0 G54 X-10 Y.20\nG1X10Y5 F200\nG91 G18\nM8\nG01 X 10 Y - 5\nN40\n"
                                      "T1 D1\nG500 Z100 M9\ng2 x5 y5 i2.5 j0\n";
    EXPECT_EQ(test::difference_of_lanes(text, "sinumerik", "lanes"), std::nullopt);
    EXPECT_GT(test::forbid_plain_lane(text, "sinumerik").plain, 6U);
}

} // namespace
} // namespace maclint
