//! Rules about jumps and calls in corner cases: MAC301, MAC303, MAC312, MAC313, MAC319, MAC336, MAC410,
//! MAC413, MAC456, MAC462.
#include "tests/rules/raised.hpp"
#include "tests/support/analysed.hpp"

#include <gmock/gmock.h>

namespace maclint {
namespace {

using test::judged;
using test::lines_raised;
using test::messages_raised;
using test::path_raised;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

TEST(JumpTarget, ThatIsMissingIsReportedWhereNothingLeadsToTheJumpYet) {
    EXPECT_THAT(lines_raised("MAC301", "O1\nM30\nGOTO70\n"), ElementsAre(3));
    EXPECT_THAT(
        messages_raised("MAC301", "O1\nN8 G0\nN5 G0\nN5 G1\nGOTO 6\nM30\n"),
        ElementsAre("Missing sequence number: 'GOTO 6' finds no N6 in this program (alarm 128). Add N6, "
                    "or correct the jump; nearest: N5 (line 3) and N8 (line 2)."));
}

TEST(JumpTarget, NeedsNoPathThatTheControlCanTake) {
    // The shop will set #108 otherwise.
    EXPECT_THAT(lines_raised("MAC301", "O1\n#108=3.\nIF[#108EQ3]GOTO3\nGOTO5003\nN3 M30\n"), ElementsAre(4));
}

TEST(JumpTarget, N0IsNotOneToAdd) {
    EXPECT_THAT(messages_raised("MAC301", "O1\nGOTO0\nM30\n"),
                ElementsAre(AllOf(HasSubstr("from 1 to 99999999"), Not(HasSubstr("Add")))));
}

TEST(ReturnTarget, IsTheProgramsOwnWhenNobodyCallsIt) {
    const auto raised = [](const std::string& text, bool complete) {
        const auto workspace = test::analyse_files({{"O1.nc", text}}, {complete, 1});
        std::vector<std::string> messages;
        for (const Finding& finding : run_rules(*workspace, {{find_rule("MAC333")}}, 1))
            messages.push_back(finding.message());
        return messages;
    };
    EXPECT_THAT(raised("O1\nG0 X1.\nM99 P50\n", true), ElementsAre(HasSubstr("goes on at its own N50")));
    EXPECT_THAT(raised("O1\nG0 X1.\nM99 P50\n", false), IsEmpty());
    EXPECT_THAT(raised("O1\nN50 G0 X1.\nM99 P50\n", true), IsEmpty());
    EXPECT_THAT(raised("O1\nM98 P2\nN50 M30\nO2\nM99 P50\n", true), IsEmpty());
}

TEST(JumpIntoLoop, IsCertainWhenEveryTargetOfAComputedJumpIsInside) {
    const std::string loop = "WHILE[#101LT5]DO1\nN20 #101=#101+1\nN30 G0 X#101\nEND1\n";
    EXPECT_THAT(lines_raised("MAC303", "O1\n#101=0\nGOTO#500\n" + loop + "M30\n"), ElementsAre(3));
    EXPECT_THAT(lines_raised("MAC303", "O1\n#101=0\nGOTO#500\n" + loop + "N40 M30\n"), IsEmpty());
}

TEST(LoopEnd, OfTheWrongNumberIsToldAtTheDoOnly) {
    const std::string text = "O1\n#101=0\nWHILE[#101LT5]DO1\n#101=#101+1\nEND2\nM30\n";
    EXPECT_THAT(lines_raised("MAC312", text), ElementsAre(3));
    EXPECT_THAT(lines_raised("MAC313", text), IsEmpty());
}

TEST(EndlessJumps, WithTwoWaysBackAreOneFinding) {
    const std::string text = "O1\nN10 G0 X1.\nIF[#500EQ1]GOTO20\nG0 X2.\nGOTO10\nN20 G0 X3.\nGOTO10\nM30\n";
    EXPECT_THAT(lines_raised("MAC336", text), ElementsAre(7));
    EXPECT_THAT(lines_raised("MAC319", text), IsEmpty());
}

TEST(EndlessJumps, ThatRepeatWhatTheReturnBehindThemWouldAreANote) {
    const auto judgement = [](const std::string& text) { return judged("MAC336", text); };
    EXPECT_THAT(judgement("O1\n#100=5.\nN10 G1 X#100 F500\nG1 X0\nGOTO10\nM99\n"), ElementsAre("note 5"));
    // a wait, a move before it, another end, arguments, a caller
    EXPECT_THAT(judgement("O1\nN10 GOTO10\nM99\n"), ElementsAre("error 2"));
    EXPECT_THAT(judgement("O1\nG0 X5.\nN10 G1 X5. F500\nG1 X0\nGOTO10\nM99\n"), ElementsAre("error 5"));
    EXPECT_THAT(judgement("O1\nN10 G1 X5. F500\nG1 X0\nGOTO10\nM30\n"), ElementsAre("error 4"));
    EXPECT_THAT(judgement("O1\nN10 G1 X#24 F500\nG1 X0\nGOTO10\nM99\n"), ElementsAre("error 4"));
    EXPECT_THAT(judgement("O1\nN10 G1 X5. F500\nG1 X0\nGOTO10\nM99\nO2\nM98P1\nM30\n"),
                ElementsAre("error 4"));
}

TEST(CallDepth, CountsACallOfAProgramThatIsNotThere) {
    EXPECT_THAT(lines_raised("MAC410", "O1\nG65P2\nM30\nO2\nG65P3\nM99\nO3\nG65P4\nM99\nO4\nG65P5\nM99\n"
                                       "O5\nG65P9999\nM99\n"),
                ElementsAre(14));
}

TEST(ModalCall, ThatACalledProgramLeavesActiveIsThatPrograms) {
    EXPECT_THAT(lines_raised("MAC413", "O1\nG65 P2\nG0 X1.\nM30\nO2\nG66 P3\nM99\nO3\nG4 X1.\nM99\n"),
                ElementsAre(6));
}

TEST(ModalCall, ThatAnUnknownProgramMayHaveEndedIsLeftAlone) {
    EXPECT_THAT(lines_raised("MAC413", "O1\nG66 P3\nX1.\nG65 P9999\nM30\nO3\nG4 X1.\nM99\n"), IsEmpty());
}

TEST(MissingReturn, IsReportedWhereAPathRunsOffTheCalledProgram) {
    EXPECT_THAT(lines_raised("MAC456", "O1\nM98 P2\nM30\nO2\nG0 X1.\nG0 X2.\n"), ElementsAre(6));
    EXPECT_THAT(
        lines_raised("MAC456", "O1\nG66 P2\nX1.\nG67\nM30\nO2\n#1=0\nWHILE[#1LT3]DO1\n#1=#1+1\nEND1\n%\n"),
        ElementsAre(10));
    EXPECT_THAT(path_raised("MAC456", "O1\nG65 P2 A1.\nM30\nO2\nIF[#1GT5]GOTO9\nM99\nN9 G0 X2.\n"),
                ElementsAre(5, 7));
    EXPECT_THAT(messages_raised("MAC456", "O1\nM98 P2\nM30\nO2\nG0 X1.\n"),
                ElementsAre(HasSubstr("O1 calls O2")));
}

TEST(MissingReturn, OfAProgramThatIsLeftOtherwiseOrThatNobodyCallsIsNone) {
    for (const std::string_view called :
         {"G0 X1.\nM30\n", "G0 X1.\nM99\n", "N1 G0 X1.\nGOTO1\n", "#3000=1(NO)\n",
          "IF[1EQ1]GOTO1\nN1 M99\nG0 X1.\n", "G0 X1.\n/M99\n", "G0 X1.\nM99]\n"})
        EXPECT_THAT(lines_raised("MAC456", "O1\nM98 P2\nM30\nO2\n" + std::string(called)), IsEmpty())
            << called;
    EXPECT_THAT(lines_raised("MAC456", "O1\nM30\nO2\nG0 X1.\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC456", "O9002\nG0 X1.\n"), IsEmpty()); // a number of macros alone
    EXPECT_THAT(lines_raised("MAC456", "O1\nM30\nM98 P2\nO2\nG0 X1.\n"), IsEmpty()); // never called
    EXPECT_THAT(lines_raised("MAC456", "O2\nM98 P2\n"), IsEmpty());                  // MAC412's
}

TEST(MissingReturn, IsReportedWhereAnotherPathShowsHowTheProgramIsLeft) {
    EXPECT_THAT(messages_raised("MAC456", "O1\nIF[#500EQ1]GOTO9\nG0 X1.\nM99\nN9 G0 X2.\n"),
                ElementsAre(AllOf(HasSubstr("Missing M99"), HasSubstr("line 4"))));
    EXPECT_THAT(messages_raised("MAC456", "O1\nIF[#500EQ1]GOTO9\nG0 X1.\nM30\nN9 (NO PART)\n"),
                ElementsAre(AllOf(HasSubstr("Missing M30"), HasSubstr("line 4"))));
    for (const std::string_view fine : {"M99\nN9#3000=1(NO)\n", "M99\nN9 G0 X2.\n/M99\n", "M99\nN9 G65 P77\n",
                                        "GOTO9\nM99\nN9 G0 X2.\n", "#3000=1(NO)\nN9 G0 X2.\n"})
        EXPECT_THAT(lines_raised("MAC456", "O1\nIF[#500EQ1]GOTO9\nG0 X1.\n" + std::string(fine)), IsEmpty())
            << fine;
}

TEST(MissingReturn, IsReportedInAProgramThatIsWrittenAsAMacro) {
    const auto said = [](const std::string& text) { return messages_raised("MAC456", text); };
    EXPECT_THAT(said("O1\nIF[#24EQ#0]THEN#24=1.\nG0 X#24\n"), ElementsAre(HasSubstr("works with #24 (X)")));
    EXPECT_THAT(said("O9001\nG0 X#24\n"), ElementsAre(HasSubstr("works with #24 (X)")));
    EXPECT_THAT(said("O1\n#33=#4003\nG91 G0 X1.\nG#33\n"), ElementsAre(HasSubstr("on line 2")));
}

TEST(MissingReturn, OfAProgramThatMayBeStartedByHandIsNone) {
    for (const std::string_view text :
         {"O1\n#24=1.\nIF[#24EQ#0]THEN#24=1.\nG0 X#24\n", // set before it is asked for
          "O1\nG0 X#24 Y#25\nG1 Z#26 F#9\nR#18\n",        // settings left out
          "O1\n#33=#4003\nG0 X1.\n",                      // saved, and never put back
          "O1\nIF[#500EQ0]GOTO9\nG0 X1.\nN9 (END)\n", "O9001\nIF[#500EQ0]GOTO9\nG0 X1.\nN9 G0 X2.\n"})
        EXPECT_THAT(lines_raised("MAC456", std::string(text)), IsEmpty()) << text;
}

TEST(MissingReturn, OfAProgramInAFolderBesideTheCallersNeedsACompleteWorkspace) {
    const auto raised = [](const std::string& path, bool complete) {
        const auto workspace =
            test::analyse_files({{"a/O1.nc", "O1\nG65 P2\nM30\n"}, {path, "O2\nG0 X1.\n"}}, {complete, 1});
        return run_rules(*workspace, {{find_rule("MAC456")}}, 1).size();
    };
    EXPECT_EQ(raised("b/O2.nc", false), 0U);
    EXPECT_EQ(raised("b/O2.nc", true), 1U);
    EXPECT_EQ(raised("a/b/O2.nc", false), 1U);
    EXPECT_EQ(raised("O2.nc", false), 1U);
}

TEST(RecursiveCall, OfALongCircleSomeProgramsAreNamed) {
    std::string text;
    for (int i = 1; i <= 20; ++i)
        text += "O" + std::to_string(i) + "\nM98 P" + std::to_string(i % 20 + 1) + "\nM99\n";
    const auto workspace = test::analyse_fanuc(text);
    const auto findings = run_rules(*workspace, {{find_rule("MAC412")}}, 1);
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_THAT(findings.front().statement(),
                testing::HasSubstr("(O1 > O2 > O3 > O4 > O5 > 11 more > O17 > O18 > O19 > O20 > O1)"));
    EXPECT_EQ(findings.front().path.size(), 9U);
}

TEST(RecursiveCall, OfAVeryLongCircleTheMiddleIsLeftOut) {
    for (const int programs : {200, 300}) {
        std::string text;
        for (int i = 1; i <= programs; ++i)
            text += "O" + std::to_string(i) + "\nM98 P" + std::to_string(i % programs + 1) + "\nM99\n";
        const auto workspace = test::analyse_fanuc(text);
        const auto findings = run_rules(*workspace, {{find_rule("MAC412")}}, 1);
        ASSERT_EQ(findings.size(), 1U);
        EXPECT_THAT(
            findings.front().statement(),
            testing::HasSubstr(programs == 200 ? " 191 more > " : "(O1 > other programs > O300 > O1)"));
    }
}

TEST(MissingReturn, IsToldWithTheCallOfAnotherFile) {
    const auto workspace =
        test::analyse_files({{"O1.nc", "O1\nG65 P2\nM30\n"}, {"O2.nc", "O2\nG0 X1.\n"}}, {false, 1});
    const auto findings = run_rules(*workspace, {{find_rule("MAC456")}}, 1);
    ASSERT_EQ(findings.size(), 1U);
    ASSERT_EQ(findings[0].related.size(), 1U);
    EXPECT_EQ(findings[0].related[0].source->path(), "O1.nc");
}

std::vector<std::string> doublings(const std::string& text) { return test::judged("MAC462", text); }

TEST(SequenceNumber, ThatOnlyAComputedJumpCanFindIsReportedWhenItStandsTwice) {
    EXPECT_THAT(doublings("O1\nGOTO#500\nN10 G0 X1.\nN10 G0 X2.\nM30\n"), ElementsAre("note 4"));
    EXPECT_THAT(doublings("O1\nN10 G0 X1.\nN10 G0 X2.\nM30\n"), IsEmpty());
}

TEST(SequenceNumber, OfBlocksThatWereCopiedWithTheirComputedJumpIsSilent) {
    const std::string table = "GOTO#500\nN1#1=1\nGOTO9\nN2#1=2\n";
    EXPECT_THAT(doublings("O1\nIF[#501EQ1]GOTO5\n" + table + "GOTO9\nN5\n" + table + "N9M30\n"), IsEmpty());
}

TEST(SequenceNumber, IsFoundByAComputedJumpFromAnywhere) {
    // The last jump begins again at the top, where it finds the first N1; the one between finds the second.
    EXPECT_THAT(doublings("O1\nN1#1=1\nGOTO#500\nN1#1=2\nGOTO#501\nM30\n"), IsEmpty());
    EXPECT_THAT(doublings("O1\nN1#1=1\nGOTO#500\nGOTO#502\nN1#1=2\nM30\n"), ElementsAre("note 5"));
    EXPECT_THAT(doublings("O1\nN1#1=1\nN1#1=2\nGOTO#500\nGOTO#501\nM30\n"), ElementsAre("note 3"));
    EXPECT_THAT(doublings("O1\nGOTO#500\nN1#1=1\nN1GOTO#501\nGOTO#502\nM30\n"), IsEmpty());
}

TEST(SequenceNumber, IsHarmlessWhereEachJumpTakesTheNextBlock) {
    const std::string part = "IF[#1GT0]GOTO5\n#3=-1\nN5 G0 X#3\n";
    EXPECT_THAT(doublings("O1\n" + part + part + "M30\n"), ElementsAre("note 7"));
    EXPECT_THAT(messages_raised("MAC462", "O1\n" + part + part + "M30\n"),
                ElementsAre(HasSubstr("'GOTO5' on line 2 goes to line 4, the next one")));
}

TEST(SequenceNumber, IsAWarningWhereAJumpBackPassesTheNearestBlock) {
    const std::string loop = "N5 #1=#1+1\nIF[#1LT3]GOTO5\n";
    EXPECT_THAT(doublings("O1\n" + loop + "#1=0\n" + loop + "M30\n"), ElementsAre("warning 6"));
    EXPECT_THAT(messages_raised("MAC462", "O1\n" + loop + "#1=0\n" + loop + "M30\n"),
                ElementsAre(HasSubstr(
                    "'GOTO5' on line 6 takes N5 of line 2, the first of the program, not that of")));
    EXPECT_THAT(doublings("O1\n" + loop + "M30\n"), IsEmpty());
}

TEST(SequenceNumber, IsAWarningWhereNothingLeadsToOneOfTheBlocks) {
    const std::string text = "O1\nIF[#1GT9]GOTO7\nN7 G0 X1.\nGOTO8\nN7 #3000=1(TOO BIG)\nN8 M30\n";
    EXPECT_THAT(doublings(text), ElementsAre("warning 5"));
    EXPECT_THAT(messages_raised("MAC462", text),
                ElementsAre(HasSubstr("takes N7 of line 3, and nothing leads to N7 of line 5")));
    // A part that nothing runs, with a jump of its own.
    EXPECT_THAT(doublings("O1\nIF[#1GT9]GOTO7\nX1.\nN7 M30\nIF[#1GT9]GOTO7\nX1.\nN7 M30\n"),
                ElementsAre("note 7"));
}

TEST(SequenceNumber, OfSeveralBlocksInOneProgramIsOneFinding) {
    const std::string part = "IF[#1EQ1]GOTO1\nIF[#1EQ2]GOTO2\nN1 X1.\nN2 X2.\n";
    EXPECT_THAT(messages_raised("MAC462", "O1\n" + part + part + "M30\n"),
                ElementsAre(HasSubstr("N1 is there more than once")));
    EXPECT_THAT(messages_raised("MAC462", "O1\n" + part + part + "M30\n"),
                ElementsAre(HasSubstr("(also N2)")));
    const std::string thrice = "O1\nIF[#1EQ1]GOTO10\nN10 G0 X1.\nN10 G0 X2.\nN10 G0 X3.\nM30\n";
    EXPECT_THAT(lines_raised("MAC462", thrice), ElementsAre(4));
}

TEST(EndInSubprogram, OfAProgramThatNeverReturns) {
    const auto ends = [](const std::string& main, const std::string& called) {
        return test::judged("MAC457", "O1\n" + main + "M30\nO9001\n" + called);
    };
    EXPECT_THAT(ends("M98P9001\nG0X1.\n", "G0Z5.\nM30\n"), ElementsAre("warning 7"));
    EXPECT_THAT(ends("G65P9001A1.\nG0X1.\n", "IF[#1EQ1]GOTO1\nM02\nN1M30\n"), ElementsAre("warning 7"));
    EXPECT_THAT(ends("M98P9001\nG0X1.\n", "IF[#1EQ1]GOTO1\nM30\nN1M99\n"), IsEmpty());
    EXPECT_THAT(ends("G0X1.\nM98P9001\n", "G0Z5.\nM30\n"), IsEmpty()); // nothing is left out
    EXPECT_THAT(ends("G0X1.\n", "G0Z5.\nM30\n"), IsEmpty());
}

} // namespace
} // namespace maclint
