//! Rules of DIN PLUS: what their examples do not show.
#include "rules/rule.hpp"
#include "tests/support/analysed.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>

namespace maclint {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<Finding> findings(const Workspace& workspace, std::string_view code) {
    return run_rules(workspace, {{find_rule(code)}}, 1);
}

std::vector<std::uint32_t> lines_in(const Workspace& workspace, std::string_view code) {
    std::vector<std::uint32_t> lines;
    for (const Finding& finding : findings(workspace, code))
        lines.push_back(finding.source->position(finding.span.begin).line);
    return lines;
}

/// 1-based lines on which the rule speaks of a main program.
std::vector<std::uint32_t> lines(std::string_view code, std::string text) {
    return lines_in(*test::analyse_text("dinplus", std::move(text)), code);
}

std::vector<std::string> messages(std::string_view code, std::string text) {
    const auto workspace = test::analyse_text("dinplus", std::move(text));
    std::vector<std::string> all;
    for (const Finding& finding : findings(*workspace, code)) all.push_back(finding.message());
    return all;
}

// ---- pairs

TEST(IfUnbalanced, TellsACrossingOnceAndOnlyForTheWordThatComesTooEarly) {
    const std::string text = "MACHINING\nIF #g1==1\nTHEN\nWHILE #g2<5\nENDIF\nENDWHILE\nEND\n";
    EXPECT_THAT(lines("DIN401", text), ElementsAre(5));
    EXPECT_THAT(lines("DIN404", text), IsEmpty());
}

TEST(IfUnbalanced, ALoopThatIsNeverClosedIsTheLoopsFaultAlone) {
    const std::string text = "MACHINING\nIF #g1==1\nTHEN\nWHILE #g2<5\n#g2=#g2+1\nENDIF\nEND\n";
    EXPECT_THAT(lines("DIN401", text), IsEmpty());
    EXPECT_THAT(lines("DIN404", text), ElementsAre(4));
}

TEST(IfUnbalanced, IsSilentWhereABlockThatNobodyCanReadMayCloseIt) {
    EXPECT_THAT(lines("DIN401", "MACHINING\nIF #g1==1\nTHEN\nN5 NDIF\nG14 Q0\nEND\n"), IsEmpty());
}

TEST(IfUnbalanced, LeavesAnIfWithoutThenToTheRuleForThat) {
    const std::string text = "MACHINING\nIF #g1==1\nG14 Q0\nM30\nEND\n";
    EXPECT_THAT(lines("DIN402", text), ElementsAre(2));
    EXPECT_THAT(lines("DIN401", text), IsEmpty());
}

TEST(IfUnbalanced, TellsBranchesWithoutIfOnce) {
    EXPECT_THAT(lines("DIN401", "MACHINING\nTHEN\nG14 Q0\nELSE\nT1\nENDIF\nENDIF\nEND\n"), ElementsAre(2, 7));
}

TEST(SwitchUnbalanced, TellsBranchesWithoutSwitchOnce) {
    EXPECT_THAT(lines("DIN409", "MACHINING\nCASE 1\nG14 Q0\nBREAK\nCASE 2\nBREAK\nENDSWITCH\nBREAK\nEND\n"),
                ElementsAre(2, 8));
}

TEST(UnitUnbalanced, TellsTheInnerOneOfTwoUnitsThatAreBothClosed) {
    EXPECT_THAT(lines("DIN015", "MACHINING\nUNIT ID\"A\"\nUNIT ID\"B\"\nEND_OF_UNIT\nEND_OF_UNIT\nEND\n"),
                ElementsAre(3));
}

// ---- branches

std::string branches(const std::string& first) {
    return "MACHINING\nINPUT(\"Size\",#l1)\nSWITCH #l1\nCASE 1\n" + first +
           "CASE 2\nG0 X30\nBREAK\nENDSWITCH\nM30\nEND\n";
}

TEST(CaseWithoutBreak, LooksAtTheWaysOutOfTheBranchAndNotAtTheText) {
    EXPECT_THAT(lines("DIN410", branches("G0 X20\n")), ElementsAre(4));
    EXPECT_THAT(lines("DIN410", branches("IF #g1==1\nTHEN\nBREAK\nELSE\nBREAK\nENDIF\n")), IsEmpty());
    EXPECT_THAT(lines("DIN410", branches("IF #g1==1\nTHEN\nBREAK\nENDIF\n")), ElementsAre(4));
    EXPECT_THAT(lines("DIN410", branches("G0 X20\nM30\n")), IsEmpty());
}

// ---- sections

TEST(Sections, AFragmentLacksNothing) {
    for (const std::string_view code : {"DIN101", "DIN102"}) {
        EXPECT_THAT(lines(code, "FINISHED\nN1 G0 X0 Z0\nN2 G1 X50\n"), IsEmpty()) << code;
        EXPECT_THAT(lines(code, "MACHINING\nN1 G14 Q0\n"), IsEmpty()) << code;
        EXPECT_THAT(lines(code, "N1 G14 Q0\n"), IsEmpty()) << code;
    }
}

TEST(Sections, AProgramWithAHeadIsWhole) {
    EXPECT_THAT(lines("DIN101", "PROGRAM HEAD\n#UNIT METRIC\nFINISHED\nN1 G0 X0 Z0\n"), ElementsAre(1));
    EXPECT_THAT(lines("DIN102", "PROGRAM HEAD\n#UNIT METRIC\nMACHINING\nN1 M30\n"), ElementsAre(4));
}

TEST(Sections, AfterEndTheFirstThingIsTold) {
    EXPECT_THAT(lines("DIN103", "MACHINING\nM30\nEND\n[said]\nSUBPROGRAM \"A\"\nG14 Q0\nRETURN\n"),
                ElementsAre(5));
    EXPECT_THAT(lines("DIN103", "MACHINING\nM30\nEND\n[said]\n\n"), IsEmpty());
}

// ---- references

std::string with_cycle(const std::string& contour, const std::string& behind) {
    return contour + "MACHINING\nN10 T1\nN11 G810 NS7 P2\nN12 M30\n" + behind + "END\n";
}

TEST(ContourReference, MayLeadToASubprogramAndIntoContoursThatAreDescribedElsewhere) {
    const std::string contour = "FINISHED\nN1 G0 X0 Z0\n";
    EXPECT_THAT(lines("DIN704", with_cycle(contour, "")), ElementsAre(5));
    EXPECT_THAT(lines("DIN704", with_cycle(contour, "SUBPROGRAM \"C\"\nN7 G1 X5\nRETURN\n")), IsEmpty());
    EXPECT_THAT(lines("DIN704", with_cycle(contour + "L\"SHAPE\" V1\n", "")), IsEmpty());
    EXPECT_THAT(lines("DIN704", with_cycle("", "")), IsEmpty());
}

TEST(ContourReference, IsLookedForInTheMainProgramFromASubprogram) {
    const std::string text = "FINISHED\nN1 G0 X0 Z0\nN2 G1 X20\nMACHINING\nL\"CUT\"\nM30\nSUBPROGRAM "
                             "\"CUT\"\nG810 NS2 P2\nG810 NS3 P2\nRETURN\nEND\n";
    EXPECT_THAT(lines("DIN704", text), ElementsAre(9));
}

TEST(DuplicateBlock, CountsOnlyWhereTheReferenceLooks) {
    const std::string head = "FINISHED\nN1 G0 X0 Z0\nN2 G1 X20\n";
    EXPECT_THAT(lines("MAC462", head + "MACHINING\nN2 T1\nN3 G810 NS2 P2\nM30\nEND\n"), IsEmpty());
    EXPECT_THAT(lines("MAC462", head + "N2 G1 Z-9\nMACHINING\nN3 T1\nM30\nEND\n"), IsEmpty());
    EXPECT_THAT(lines("MAC462", "MACHINING\nN20 T1\nN20 T2\nM99 NS20\nEND\n"), ElementsAre(3));
}

TEST(RestartTarget, MustStandInTheMachiningPart) {
    EXPECT_THAT(lines("DIN415", "FINISHED\nN1 G0 X0 Z0\nMACHINING\nN2 T1\nN3 M99 NS1\nEND\n"),
                ElementsAre(5));
    EXPECT_THAT(lines("DIN415", "MACHINING\nN2 T1\nN3 M99 NS2\nEND\n"), IsEmpty());
    // From a subprogram, too: it is the program that begins again.
    const std::string main = "MACHINING\nN2 T1\nN3 L\"A\" V1\nN4 M30\nSUBPROGRAM \"A\"\n";
    EXPECT_THAT(lines("DIN415", main + "N5 M99 NS2\nRETURN\nEND\n"), IsEmpty());
    EXPECT_THAT(lines("DIN415", main + "N5 M99 NS5\nRETURN\nEND\n"), ElementsAre(6));
    EXPECT_THAT(lines("DIN415", "MACHINING\nN2 T1\nN3 M99\nEND\n"), IsEmpty());
    EXPECT_THAT(lines("DIN415", "MACHINING\nN2 T1\nN3 M99 NS#l1\nEND\n"), IsEmpty());
}

TEST(BlockReferences, SayWhereTheirBlockStands) {
    EXPECT_THAT(
        messages("DIN415", "FINISHED\nN1 G0 X0 Z0\nMACHINING\nN3 M99 NS1\nN4 M99 NS9\nEND\n"),
        ElementsAre(HasSubstr("N1, which stands in FINISHED"), HasSubstr("N9, which does not exist")));
    EXPECT_THAT(messages("DIN704", "FINISHED\nN1 G0 X0 Z0\nMACHINING\nN2 T1\nN3 G810 NS2 P2\nM30\nEND\n"),
                ElementsAre(HasSubstr("N2, which stands in MACHINING")));
}

// ---- what stays on

TEST(RadiusCompensation, IsFollowedToWhereItIsSwitchedOn) {
    const auto workspace = test::analyse_text(
        "dinplus", "MACHINING\nIF #g1==1\nTHEN\nG0 X18 Z3\nENDIF\nG42\nG1 Z-30\nT2\nG40\nM30\nEND\n");
    const auto found = findings(*workspace, "DIN619");
    ASSERT_EQ(found.size(), 1U);
    const auto& path = found.front().path;
    ASSERT_FALSE(path.empty());
    for (std::size_t i = 1; i < path.size(); ++i) EXPECT_LT(path[i - 1].span.begin, path[i].span.begin);
}

// ---- variables

std::string called(const std::string& calls, const std::string& body) {
    return "MACHINING\n" + calls + "M30\nSUBPROGRAM \"S\"\n" + body + "RETURN\nEND\n";
}

TEST(TransferValue, NeedsNoQuestionWhenEveryCallPassesIt) {
    EXPECT_THAT(lines("DIN330", called("L\"S\" LA1\nL\"S\" LA2\n", "G0 X#__la\n")), IsEmpty());
    EXPECT_THAT(lines("DIN330", called("L\"S\" LA1\nL\"S\"\n", "G0 X#__la\n")), ElementsAre(6));
    EXPECT_THAT(lines("DIN330", "MACHINING\nG0 X#__la\nRETURN\n"), IsEmpty());
}

TEST(TransferValue, IsAskedForByNdefOnTheWay) {
    EXPECT_THAT(
        lines("DIN330", called("L\"S\"\nL\"S\" LA1\n", "IF NDEF(__la)\nTHEN\nRETURN\nENDIF\nG0 X#__la\n")),
        IsEmpty());
    EXPECT_THAT(
        lines("DIN330", called("L\"S\"\nL\"S\" LA1\n", "IF NDEF(__la)\nTHEN\nG14 Q0\nENDIF\nG0 X#__la\n")),
        ElementsAre(10));
}

TEST(TransferValue, IsAskedForBesideItsTestInTheSameCondition) {
    const auto under = [](const std::string& condition) {
        return lines("DIN330", called("L\"S\"\nL\"S\" LA1\n", "IF " + condition + "\nTHEN\nG14 Q0\nENDIF\n"));
    };
    EXPECT_THAT(under("#__la==0"), ElementsAre(6));
    EXPECT_THAT(under("NDEF(__la) OR (#__la==0)"), IsEmpty());
    EXPECT_THAT(under("DEF(__la) AND (#__la>5)"), IsEmpty());
}

TEST(UninitialisedLocal, IsNamedAsItIsWrittenAndMayBeAskedForInTheSameCondition) {
    const std::string head = "VAR\n#_a=#l1\nMACHINING\n";
    const std::string tail = "\nTHEN\nG0 X1\nENDIF\nM30\nEND\n";
    EXPECT_THAT(messages("MAC209", head + "IF #_a>3" + tail), ElementsAre(HasSubstr("set #_a before")));
    EXPECT_THAT(lines("MAC209", head + "IF DEF(_a) AND (#_a>3)" + tail), IsEmpty());
}

TEST(TransferValue, IsNotJudgedWhereNobodyKnowsWhatAnIfGuards) {
    EXPECT_THAT(lines("DIN330", called("L\"S\"\n", "IF DEF(__la)\nTHEN\nG0 X#__la\n")), IsEmpty());
}

TEST(UninitialisedLocal, IsNotOneThatACallerHandsDown) {
    EXPECT_THAT(lines("MAC209", called("#l1=5\nL\"S\"\n", "G0 X#l1\n")), ElementsAre(6));
    EXPECT_THAT(lines("MAC209", called("#l1(5)\nL\"S\"\n", "G0 X#l1\n")), IsEmpty());
}

TEST(UninitialisedLocal, MayBeTheCounterOfALoop) {
    EXPECT_THAT(lines("MAC209", "MACHINING\nWHILE #l1<3\nG0 X1\n#l1=#l1+1\nENDWHILE\nM30\nEND\n"),
                ElementsAre(2));
}

TEST(TransferValue, IsLeftOutOnlyWhereACallThatLeavesItOutComesToIt) {
    const auto raised = [](const std::string& calls, const std::string& body) {
        return lines("DIN330", "MACHINING\n" + calls + "M30\nSUBPROGRAM \"S\"\n" + body + "RETURN\nEND\n");
    };
    const std::string calls = "L\"S\" LH1 LA10\nL\"S\" LH2 LB20\n";
    const std::string body = "IF #__lh==1\nTHEN\nG0 X#__la\nELSE\nG0 Z#__lb\nENDIF\n";
    EXPECT_THAT(raised(calls, body), IsEmpty()); // the letter H decides
    EXPECT_THAT(raised(calls + "L\"S\" LH1\n", body), ElementsAre(9));
    EXPECT_THAT(raised("L\"S\" LA10 LH1\nL\"S\" LH2 LA10\n", body), ElementsAre(10));
    // A loop in front, with a branch that this call does not take.
    EXPECT_THAT(raised("L\"S\" LH1 LA10\n", "#l1=0\nWHILE #l1<3\nIF #__lh==2\nTHEN\nG0 X1\nENDIF\n#l1=#l1+1\n"
                                            "ENDWHILE\nG0 Z#__lb\n"),
                ElementsAre(13));
    // Both or none are passed.
    const std::string pair = "IF DEF(__lb)\nTHEN\nG1 Zi-#__lb Xi#__lc\nENDIF\n";
    EXPECT_THAT(raised("L\"S\"\nL\"S\" LB1 LC3\n", pair), IsEmpty());
    EXPECT_THAT(raised("L\"S\" LB2\nL\"S\" LB1 LC3\n", pair), ElementsAre(8));
}

TEST(LoopVariable, MustBeSetOnEveryWayToTheLoop) {
    const std::string loop = "WHILE #c4<10\nG0 X10\n#c4=#c4+1\nENDWHILE\nM30\nEND\n";
    EXPECT_THAT(lines("DIN407", "MACHINING\nIF #g1==1\nTHEN\n#c4=0\nENDIF\n" + loop), ElementsAre(6));
    EXPECT_THAT(lines("DIN407", "MACHINING\n#c4=0\n" + loop), IsEmpty());
    EXPECT_THAT(lines("DIN407", "MACHINING\nIF NDEF(#c4)\nTHEN\n#c4=0\nENDIF\n" + loop), IsEmpty());
    EXPECT_THAT(lines("DIN407", "MACHINING\nIF DEF(#c4)\nTHEN\n#c4=0\nENDIF\n" + loop), ElementsAre(6));
    EXPECT_THAT(lines("DIN407", "MACHINING\nWHILE #g4<10\nG0 X10\n#g4=#g4+1\nENDWHILE\nM30\nEND\n"),
                IsEmpty());
}

TEST(ConstantCondition, ALoopThatAPauseCanEndMayRunForEver) {
    EXPECT_THAT(lines("MAC718", "MACHINING\nWHILE 1==1\nG0 X1\nENDWHILE\nEND\n"), ElementsAre(2));
    EXPECT_THAT(lines("MAC718", "MACHINING\nWHILE 1==1\nG0 X1\nM0\nENDWHILE\nEND\n"), IsEmpty());
    EXPECT_THAT(lines("MAC319", "MACHINING\nWHILE 1==1\nG0 X1\nENDWHILE\nEND\n"), IsEmpty());
}

TEST(ConstantCondition, ALoopThatAReturnOrTheProgramsEndLeavesMayRunForEver) {
    const auto raised = [](const std::string& condition, const std::string& way_out) {
        return lines("MAC718", "MACHINING\nINPUT(\"N\",#l1)\nWHILE 1==1\nG0 X1\nIF " + condition +
                                   "\nTHEN\n" + way_out + "\nENDIF\nENDWHILE\nEND\n");
    };
    EXPECT_THAT(raised("#l1==1", "M30"), IsEmpty());
    EXPECT_THAT(raised("#l1==1", "RETURN"), IsEmpty());
    EXPECT_THAT(raised("#l1==1", "G0 X2"), ElementsAre(3));
    EXPECT_THAT(raised("1==2", "M30"), ElementsAre(3));
}

// ---- what stays switched on

TEST(RadiusCompensation, IsToldOnceWhereverItIsStillActive) {
    const std::string text = "MACHINING\nG42\nG1 Z-30\nG14 Q0\nT2\nM30\nEND\n";
    EXPECT_THAT(lines("DIN619", text), ElementsAre(2));
    EXPECT_THAT(lines("DIN619", "MACHINING\nG41 Q1\nG1 X5\nG19\nG40\nM30\nEND\n"), ElementsAre(2));
    EXPECT_THAT(lines("DIN619", "MACHINING\nG18\nG42\nG18\nG1 X5\nG40\nM30\nEND\n"), IsEmpty());
}

TEST(RadiusCompensation, MayBeSwitchedOnAndOffUnderTheSameCondition) {
    const auto text = [](const std::string& off) {
        return "MACHINING\nIF #g1==1\nTHEN\nG42\nENDIF\nG1 X5\nIF " + off +
               "\nTHEN\nG40\nENDIF\nG14 Q0\nM30\nEND\n";
    };
    EXPECT_THAT(lines("DIN619", text("#g1==1")), IsEmpty());
    EXPECT_THAT(lines("DIN619", text("#g1==2")), ElementsAre(4));
}

TEST(RadiusCompensation, LastsThroughALoop) {
    const auto text = [](const std::string& body) {
        return "MACHINING\nG42\n#l1=0\nWHILE #l1<3\nG1 X#l1\n#l1=#l1+1\n" + body + "ENDWHILE\nM30\nEND\n";
    };
    EXPECT_THAT(lines("DIN619", text("")), ElementsAre(2));
    EXPECT_THAT(lines("DIN619", text("G40\n")), IsEmpty());
}

TEST(RadiusCompensation, OfASubprogramIsTheSubprogramsOwnFault) {
    const std::string text = called("L\"S\"\nG0 X9\n", "G42\nG1 Z-5\nG14 Q0\n");
    EXPECT_THAT(lines("DIN519", text), ElementsAre(6));
    EXPECT_THAT(lines("DIN619", text), IsEmpty());
}

TEST(RadiusCompensation, OfASubprogramIsNoFaultWhenEveryCallerCancelsItBeforeItMoves) {
    EXPECT_THAT(lines("DIN519", called("L\"S\"\nG40\nG0 X9\n", "G42\nG1 Z-5\n")), IsEmpty());
}

TEST(Mirroring, MayBeSwitchedOnForACallerThatSwitchesItOff) {
    EXPECT_THAT(lines("DIN519", called("L\"S\"\nG0 X9\nG30 Q0\n", "G30 H1 Q3\n")), IsEmpty());
    EXPECT_THAT(lines("DIN519", called("L\"S\"\nG0 X9\n", "G30 H1 Q3\n")), ElementsAre(6));
}

TEST(ZeroShifts, AShiftIsLeftOnDeliberately) {
    EXPECT_THAT(lines("DIN519", called("L\"S\"\nG0 X9\n", "G56 Z-5\n")), IsEmpty());
}

TEST(ProgramNotFound, ALocalSubprogramMustBeInTheFile) {
    EXPECT_THAT(lines("MAC402", "MACHINING\nL\"A\"\nM30\nEND\n"), ElementsAre(2));
    EXPECT_THAT(lines("MAC402", "MACHINING\nL\"A\"\nM30\n"), IsEmpty());
    EXPECT_THAT(lines("MAC402", "MACHINING\nL\"A\" V1\nM30\nEND\n"), IsEmpty());
}

TEST(Severity, FollowsTheLanguage) {
    const auto found = [](std::string_view dialect, std::string text) {
        const auto workspace = test::analyse_text(dialect, std::move(text));
        return findings(*workspace, "MAC412").at(0).severity;
    };
    EXPECT_EQ(found("fanuc", "O1\nM98P1\nM30\n"), Severity::error);
    EXPECT_EQ(found("dinplus", called("L\"S\"\n", "L\"S\"\n")), Severity::warning);
}

TEST(MissingReturn, IsDemandedOfEverySubprogramThatEndDoesNotClose) {
    const auto raised = [](const std::string& text) {
        const auto workspace = test::analyse_files(
            {{"MAIN.nc", "MACHINING\nN1 L\"SUB\" V1\nN2 M30\nEND\n"}, {"SUB.ncs", text}}, {false, 1});
        return lines_in(*workspace, "DIN506");
    };
    EXPECT_THAT(raised("%SUB.ncs\nMACHINING\nN10 G0 X5\n"), ElementsAre(3));
    EXPECT_THAT(raised("%SUB.ncs\nMACHINING\nN10 G0 X5\nRETURN\n"), IsEmpty());
    EXPECT_THAT(raised("%SUB.ncs\nMACHINING\nN10 G0 X5\nN20 M30\n"), IsEmpty());
    EXPECT_THAT(raised("%SUB.ncs\nMACHINING\nN10 G0 X5\nEND\n"), IsEmpty());
    const std::string main = "MACHINING\nN1 L\"SUB\"\nN2 M30\n";
    EXPECT_THAT(
        messages("DIN506", main + "SUBPROGRAM \"SUB\"\nN3 IF #c1>0\nN4 THEN\nN5 G0 X1\nN6 ENDIF\nEND\n"),
        ElementsAre(HasSubstr("Missing RETURN")));
}

TEST(DivisionByZero, ByWhatIsUndefinedIsNotCertain) {
    EXPECT_THAT(lines("MAC702", "MACHINING\nN1 #l1=0\nN2 #l2=5/#l1\nN3 M30\nEND\n"), ElementsAre(3));
    EXPECT_THAT(lines("MAC702", "MACHINING\nN2 #l2=5/#l1\nN3 M30\nEND\n"), IsEmpty());
    EXPECT_THAT(
        lines("MAC702", "%S.ncs\nMACHINING\nN1 IF NDEF(__la)\nN2 THEN\nN3 #l2=5/#__la\nN4 ENDIF\nRETURN\n"),
        IsEmpty());
}

TEST(DinConditions, OfSettingsAreMeantAndOthersAreReported) {
    EXPECT_THAT(lines("MAC718", "MACHINING\n#l1=5\n#l2=#l1*2\nIF #l2>0\nTHEN\nG0 X1\nENDIF\nEND\n"),
                IsEmpty());
    EXPECT_THAT(lines("MAC718",
                      "MACHINING\nINPUT(\"A\",#l1)\nIF #l1<=50\nTHEN\nIF #l1>80\nTHEN\nG0 X1\nENDIF\n"
                      "ENDIF\nEND\n"),
                ElementsAre(5));
}

TEST(DinEquality, WithZeroIsSafeWhereRoundingCannotMakeIt) {
    const auto asked = [](std::string_view expression) {
        return "MACHINING\nINPUT(\"A\",#l1)\nINPUT(\"B\",#l2)\n#l3=" + std::string(expression) +
               "\nIF #l3==0\nTHEN\nG0 X1\nENDIF\nEND\n";
    };
    EXPECT_THAT(lines("MAC710", asked("ABS(#l1/7)")), IsEmpty());
    EXPECT_THAT(lines("MAC710", asked("ABS(COS(#l1))")), ElementsAre(5));
    EXPECT_THAT(lines("MAC710", asked("ABS(#l1-#l2)")), ElementsAre(5));
}

} // namespace
} // namespace maclint
