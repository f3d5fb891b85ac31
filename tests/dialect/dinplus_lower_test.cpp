//! What DIN PLUS blocks become in the program model.
#include "analyzer/program/tables.hpp"
#include "tests/dialect/reading.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

/// The blocks of a MACHINING section and the irregularities, one a line.
std::string din(std::string_view blocks) {
    return test::lower(test::read_as("dinplus", "part.nc", "MACHINING\n" + std::string(blocks)));
}

/// The same for a program that begins otherwise.
std::string whole(std::string_view text) { return test::lower(test::read_as("dinplus", "part.nc", text)); }

TEST(DinWords, ACodeSetsItsGroupAndItsWord) {
    EXPECT_EQ(din("N1 G96 S200 G95 F0.3 M4"),
              "N1 kind of speed=96; spindle speed=200; kind of feed=95; feed=0.3.");
    EXPECT_EQ(din("N1 G4 F2"), "N1 synchronise"); // a dwell, no feed
    EXPECT_EQ(din("N1 G#l1"), "N1 values #l1; modal=#l1");
}

TEST(DinWords, AWordSwitchesOff) {
    EXPECT_EQ(din("N1 G16 B30 Q1"), "N1 tilted working plane=16");
    EXPECT_EQ(din("N1 G16 Q0"), "N1 tilted working plane=0");
    EXPECT_EQ(din("N1 G30 Q#l1"), "N1 values #l1; conversion and mirroring=unreadable");
}

TEST(DinWords, AxesMoveByACodeOrByTheLastMotion) {
    EXPECT_EQ(din("N1 G1 X10"), "N1 motion mode=1; move");
    EXPECT_EQ(din("N1 X10 Zi-2"), "N1 move");
    EXPECT_EQ(din("N1 G95 F0.1 X10"), "N1 kind of feed=95; feed=0.1.; move");
    EXPECT_EQ(din("N1 G59 Z100"), "N1 zero shift=59");
    EXPECT_EQ(din("N1 G14 Q0"), "N1 to the tool change position; rapid move");
    EXPECT_EQ(din("N1 GO X5"), "N1 motion mode=0; move\n! letter-o 'GO' -> G0");
}

TEST(DinWords, ValuesAreExpressionsWithoutBrackets) {
    EXPECT_EQ(din("N1 X100+#l1"), "N1 values add(100, #l1); move");
    EXPECT_EQ(din("N1 Z-5-#l1*2"), "N1 values subtract(-5, multiply(#l1, 2)); move");
    EXPECT_EQ(din("N1 X(37+2)*SIN (30)"), "N1 values multiply(add(37, 2), sin(30)); move");
    EXPECT_EQ(din("N1 X-_pi"), "N1 values negate(3.1415926535989); move");
}

TEST(DinWords, AddressAndIncrementAreRecorded) {
    const ProgramFile file = test::read_as("dinplus", "p.nc", "MACHINING\nN1 XKi5 ID\"a\" Zi#l1 ANi30+_a");
    const Program& program = file.programs.at(0);
    ASSERT_EQ(program.words.size(), 4U);
    EXPECT_EQ(program.words[0].address, "XK");
    EXPECT_TRUE(program.words[0].incremental);
    EXPECT_EQ(program.words[1].address, "ID");
    EXPECT_FALSE(program.words[1].incremental);
    EXPECT_EQ(program.words[2].address, "Z");
    EXPECT_TRUE(program.words[2].incremental);
    EXPECT_EQ(program.words[3].address, "AN");
    EXPECT_TRUE(program.words[3].incremental);
}

TEST(DinWords, BlockWordsReferToAContour) {
    EXPECT_EQ(din("N1 G810 NS4 NE#l1 P2"), "N1 values #l1; contour block 4; contour block #l1; move");
    EXPECT_EQ(din("N1 G1 X5 NS4"), "N1 motion mode=1; move");
}

TEST(DinWords, MachineFunctionsStopEndAndRestart) {
    EXPECT_EQ(din("N1 M0"), "N1 synchronise; pause");
    EXPECT_EQ(din("N1 M30"), "N1 synchronise; end");
    EXPECT_EQ(din("N1 M99"), "N1 synchronise; restart");
    EXPECT_EQ(din("N1 M99 NS20"), "N1 synchronise; restart 20");
    EXPECT_EQ(din("N1 T3"), "N1 tool change");
}

TEST(DinBlocks, SkipLevelsAreDigits) {
    EXPECT_EQ(din("/159 N1 M0"), "N1 /1 /5 /9 synchronise; pause");
    EXPECT_EQ(din("$1 / N 12 M0"), "$1 N12 /1 synchronise; pause");
}

TEST(DinRegions, BranchesLoopsAndUnits) {
    EXPECT_EQ(din("N1 IF (#l1==1) AND (#g2<>0)\nN2 THEN\nN3 ELSE\nN4 ENDIF"),
              "N1 open choice all-of(equal(#l1, 1), not-equal(#g2, 0))\nN2 begin choice\nN3 middle choice\n"
              "N4 close choice");
    EXPECT_EQ(din("WHILE #l1<=5\nENDWHILE"), "open while less-equal(#l1, 5)\nclose while");
    EXPECT_EQ(din("N1 UNIT ID\"START\"\nN2 END_OF_UNIT 4711"), "N1 open unit\nN2 close unit");
}

TEST(DinRegions, ACaseComparesWithTheInnermostSwitch) {
    EXPECT_EQ(din("SWITCH #l1\nCASE 1\nSWITCH #l2\nCASE 2\nENDSWITCH\nBREAK\nCASE -1\nDEFAULT\nENDSWITCH"),
              "values #l1; open selection\nmiddle selection equal(#l1, 1)\n"
              "values #l2; open selection\nmiddle selection equal(#l2, 2)\nclose selection\n"
              "leave selection\nmiddle selection equal(#l1, -1)\nmiddle selection\nclose selection");
}

TEST(DinCalls, WordsBecomeArgumentsOfTheirFormals) {
    EXPECT_EQ(din("N1 L\"GROOVE\" V1 LA10 LB#l2+1 Q2"),
              "N1 call call of an external subprogram GROOVE LA>#__la=10 LB>#__lb=add(#l2, 1) times 2");
    EXPECT_EQ(din("N1 L\"1\" V0 ID\"a\""), "N1 call call of a local subprogram 1 ID>#__id=\"a\"");
    EXPECT_EQ(din("RETURN #l5"), "return #l5");
}

TEST(DinCalls, InputStoresPrintReads) {
    EXPECT_EQ(din("INPUT(\"D?\",#l1)"), "exchange out \"D?\" in #l1; synchronise");
    EXPECT_EQ(din("INPUT(\"D?\",#g(#l1))"), "exchange out \"D?\"; #[#l1] := unreadable; synchronise");
    EXPECT_EQ(din("INPUT(\"D?\",#m4(Z))"), "exchange out \"D?\"; machine #m4 := unreadable; synchronise");
    EXPECT_EQ(din("PRINT(\"D \",#l1)"), "exchange out \"D \" out #l1");
    EXPECT_EQ(din("WINDOW(8)"), "exchange out 8");
}

TEST(DinVariables, EveryKindHasItsSpace) {
    EXPECT_EQ(din("#l1=#c2+#g3"), "#l1 := add(#c2, #g3)");
    EXPECT_EQ(din("#x1=\"a\"+STRING(#l1,2)"), "#x1 := add(\"a\", unknown(#l1, 2))");
    EXPECT_EQ(din("#g(#c2)=#g(#l1)"), "#[#c2] := #[#l1]");
    EXPECT_EQ(din("#l1=#i99"), "#l1 := machine #i99");
    EXPECT_EQ(din("#m4(Z)=350"), "machine #m4 := 350");
    EXPECT_EQ(din("#l1=#n40(G)"), "#l1 := modal(radius compensation)");
    EXPECT_EQ(din("#l1=#n95(F)+__n97_s"), "#l1 := add(modal(feed), modal(spindle speed))");
    EXPECT_EQ(din("#l1=#__la"), "#l1 := #__la");
}

TEST(DinVariables, WhatSelectorsComputeIsRead) {
    EXPECT_EQ(din("#l1=#w0(#l7)"), "#l1 := #[unknown(#l7)]");
    EXPECT_EQ(din("#l1=#a1(Z,#l2+1)"), "#l1 := #[unknown(add(#l2, 1))]");
    EXPECT_EQ(din("#l1=#t(3,\"001\")"), "#l1 := machine #t0");
    EXPECT_EQ(din("#l1=#t(#l2,\"001\")"), "#l1 := #[unknown(#l2)]");
    EXPECT_EQ(din("#l1=#m(#l2)(#l3)"), "#l1 := #[unknown(#l3, #l2)]");
    EXPECT_EQ(din("#m(#l2)(Z)=5"), "#[#l2] := 5");
    EXPECT_EQ(din("#d1(Z,#l2)=5"), "#[unknown(#l2)] := 5");
}

TEST(DinVariables, TestsForAValueTakeNamesWithoutTheirSign) {
    for (const char* test : {"NDEF(#l1)", "DEF(__la)", "DEF(_depth)", "NDEF(#a9(X))", "DEF(#g(#l1))"})
        EXPECT_EQ(din("IF " + std::string(test) + "\nTHEN\nENDIF").find('!'), std::string::npos) << test;
    EXPECT_THAT(din("IF NDEF(#__la)\nTHEN\nENDIF"), ::testing::EndsWith("'NDEF(#__la)' -> NDEF(__la)"));
    EXPECT_THAT(din("IF DEF( # _depth)\nTHEN\nENDIF"), ::testing::HasSubstr("-> DEF(_depth)"));
}

TEST(DinVariables, NamesOfVarStandForWhatTheyName) {
    EXPECT_EQ(whole("VAR\n#_d=#l1\n#_e=#g201(5)\n#_f=7\nMACHINING\n#_d=#_e+#_f"),
              "\n#g201 := 5\n#_f := 7\n#l1 := add(#g201, #_f)");
}

TEST(DinVariables, ConstantsAreStoredOnce) {
    EXPECT_EQ(whole("CONST\n_a=3\n_b=_a*2\n_c=__la\nMACHINING\nX_b"),
              "_a := 3\n_b := multiply(_a, 2)\n_c := #__la\nvalues _b; move");
}

TEST(DinVariables, WhatIsHandedDownIsKnown) {
    const ProgramFile file =
        test::read_as("dinplus", "p.nc", "CONST\n_a=3\nVAR\n#_d=#l90(5)\n#_e=#l2\nMACHINING\n#l7(1)");
    const Program& program = file.programs.at(0);
    std::vector<std::string> names;
    for (const Variable variable : program.handed_down) names.push_back(program.spell(variable));
    EXPECT_EQ(names, (std::vector<std::string>{"_a", "#_d", "#l90", "#_e", "#l7"}));
}

TEST(DinVacancy, TheNameStandsWithoutItsSign) {
    EXPECT_EQ(din("IF DEF(__la)\nTHEN\nENDIF"), "open choice set?(#__la)\nbegin choice\nclose choice");
    EXPECT_EQ(din("IF NDEF(l1)\nTHEN\nENDIF"), "open choice vacant?(#l1)\nbegin choice\nclose choice");
    EXPECT_EQ(din("IF NDEF(a9(X))\nTHEN\nENDIF"), din("IF NDEF(#a9(X))\nTHEN\nENDIF"));
    EXPECT_EQ(whole("VAR\n#_t=#l1\nMACHINING\nIF NDEF(_t)\nTHEN\nENDIF"),
              "\nopen choice vacant?(#l1)\nbegin choice\nclose choice");
    EXPECT_EQ(din("IF DEF(#__la)\nTHEN\nENDIF"), "open choice set?(#__la)\nbegin choice\nclose choice\n! "
                                                 "hash-in-vacancy-test 'DEF(#__la)' -> DEF(__la)");
}

TEST(DinSyntaxErrors, AssignmentAndComparisonAreKeptApart) {
    EXPECT_EQ(
        din("IF #l1=1\nTHEN\nENDIF"),
        "open choice equal(#l1, 1)\nbegin choice\nclose choice\n! assignment-in-condition '=' -> #l1==1");
    EXPECT_EQ(din("#l1==1"), "#l1 := 1\n! comparison-as-assignment '==' -> #l1=1");
}

TEST(DinSyntaxErrors, ThenMustFollowAndBeAlone) {
    EXPECT_EQ(din("IF #l1==1\nX5\nENDIF"),
              "open choice equal(#l1, 1)\nmove\nclose choice\n! then-missing 'IF #l1==1' -> THEN");
    EXPECT_EQ(din("IF #l1==1 THEN\nENDIF"),
              "open choice equal(#l1, 1); begin choice\nclose choice\n! not-alone 'THEN'");
    EXPECT_EQ(din("ENDIF X5"), "close choice; move\n! not-alone 'ENDIF'");
    // One cause, one report.
    EXPECT_EQ(din("IF #l1==1\nTHN\nENDIF"), "open choice equal(#l1, 1)\nunreadable opens-or-closes\n"
                                            "close choice\n! unknown-keyword 'THN' -> THEN");
}

TEST(DinSyntaxErrors, ContoursAndListsDoNotMove) {
    EXPECT_EQ(whole("TURRET 1\nT1 ID\"A\"\nBLANK\nN1 G20 X#l1\nN2 #l2=5\nFINISHED\nN3 G0 X0 Z0"),
              "\nN1 values #l1\nN2 #l2 := 5\nN3 ");
}

} // namespace
} // namespace maclint
