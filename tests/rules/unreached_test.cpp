//! Rules about blocks that nothing reaches, and about ends, in corner cases: MAC302, MAC455, MAC460.
#include "tests/rules/raised.hpp"
#include "tests/support/analysed.hpp"

#include <string>

#include <gmock/gmock.h>

namespace maclint {
namespace {

using test::judged;
using test::lines_raised;
using test::messages_raised;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(UnreachableCode, IsAnAlarmThatNoJumpLeadsToWhereJumpsLeadToOthers) {
    const std::string alarms = "G0 X#24 Y#25\nM99\nN91 #3000=1(X)\nN92 M5\n#3000=2(Y)\n";
    EXPECT_THAT(messages_raised("MAC460", "O9001\nIF[#24EQ#0]GOTO91\n" + alarms),
                ElementsAre(HasSubstr("no jump leads to N92, so that '#3000=2' is never raised")));
    EXPECT_THAT(judged("MAC460", "O9001\nIF[#24EQ#0]GOTO91\nIF[#25EQ#0]GOTO92\n" + alarms), IsEmpty());
    // Nothing leads to any alarm: they may be kept for later.
    EXPECT_THAT(judged("MAC460", "O9001\n" + alarms), IsEmpty());
    // A computed jump may go anywhere.
    EXPECT_THAT(judged("MAC460", "O9001\nIF[#24EQ#0]GOTO#1\n" + alarms), IsEmpty());
}

TEST(UnreachableCode, IsAWarningOfAnAlarmThatARemarkNames) {
    const std::string alarms = "G0 X#24 Y#25\nM99\nN91 #3000=1(X)\nN92 #3000=2(Y)\n";
    EXPECT_THAT(judged("MAC460", "O9001\nIF[#24EQ#0]GOTO91\n(IF[#25EQ#0]GOTO92)\n" + alarms),
                ElementsAre("note 7"));
    // Tables of alarms are copied from macro to macro; a remark that names the number says what was meant.
    EXPECT_THAT(judged("MAC460", "O9001\nIF[#24EQ#0]GOTO91\n(WITHOUT Y TO N0092)\n" + alarms),
                ElementsAre("warning 7"));
    EXPECT_THAT(judged("MAC460", "O9001\nIF[#24EQ#0]GOTO91\n(WITHOUT Y TO N924)\n" + alarms),
                ElementsAre("note 7"));
}

TEST(UnreachableCode, StandsBehindAJumpAnAlarmOrAnEnd) {
    const std::string begin = "O9001\nIF[#1EQ2]GOTO5\nG0 X1.\n", end = "N5 M99\n";
    EXPECT_THAT(messages_raised("MAC460", begin + "GOTO5\nG0 Z5.\n" + end),
                ElementsAre(HasSubstr("'G0 Z5.' stands behind 'GOTO5' on line 4 and is never run")));
    EXPECT_THAT(judged("MAC460", begin + "GOTO5\nG0 Z5.\n" + end), ElementsAre("note 5"));
    EXPECT_THAT(judged("MAC460", begin + "M99\nM0\n#100=1\n" + end), ElementsAre("warning 6"));
    EXPECT_THAT(lines_raised("MAC460", begin + "#3000=1(X)\nG28 G91 Z0\n" + end), ElementsAre(5));
    EXPECT_THAT(lines_raised("MAC460", "O1\nG0 X1.\nM30\nN9 M5\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC460", "O1\nG0 X1.\nM30\nN9 M5\n#500=1\n"), ElementsAre(4));
    EXPECT_THAT(lines_raised("MAC460", "O1\nG0 X1.\nM30\nN9 G0 X5.\n"), ElementsAre(4));
    // A stop behind a stop does nothing by itself, nor does the wait of G4.
    EXPECT_THAT(judged("MAC460", begin + "#3000=1(X)\nM0\nG4 X999.\n" + end), IsEmpty());
}

TEST(UnreachableCode, IsMeantBehindARemarkOrWithAnEndOfItsOwn) {
    const std::string begin = "O9001\nIF[#1EQ2]GOTO5\nG0 X1.\n", end = "N5 M99\n";
    EXPECT_THAT(judged("MAC460", begin + "GOTO5(DELETE TO RETRACT)\nG0 Z5.\n" + end), IsEmpty());
    // Further starts of a program.
    EXPECT_THAT(judged("MAC460", "O1\nT1 M6\nM30\nN6 T6 M6\nG0 X1.\nM30\n"), IsEmpty());
    // The whole program is switched off.
    EXPECT_THAT(judged("MAC460", "O9001\n#3000=1(SET ME UP)\nG0 X1.\nM99\n"), IsEmpty());
    EXPECT_THAT(judged("MAC460", "O9001\nGOTO1\nG0 X1.\nN1 #3000=1(SET ME UP)\n"), ElementsAre("note 3"));
}

TEST(UnreachableCode, WithANumberIsANoteWhenItMoves) {
    const std::string begin = "O9001\nIF[#1EQ2]GOTO5\nG0 X1.\nGOTO5\n", end = "N5 M99\n";
    EXPECT_THAT(judged("MAC460", begin + "N3 G0 Z5.\n" + end), ElementsAre("note 5"));
    EXPECT_THAT(judged("MAC460", begin + "N3 G65 P9100\n" + end), ElementsAre("note 5"));
    EXPECT_THAT(judged("MAC460", begin + "N3 #15=#0\n" + end), IsEmpty());
}

TEST(UnreachableCode, LeavesWhatOtherRulesSayToThem) {
    // A loop that nothing ends, a number that stands twice, a call that does not return, a remark without its
    // brackets.
    EXPECT_THAT(judged("MAC460", "O9001\nN1 G0 X1.\nX2.\nGOTO1\nG0 Z5.\n"), IsEmpty());
    const std::string twice = "N3 G0 X1.\nIF[#1EQ2]GOTO5\nGOTO5\nN3 G0 Z5.\nN5 M99\n";
    EXPECT_THAT(judged("MAC460", "O9001\nM98 P2\n" + twice + "O2\nM99 P3\n"), IsEmpty());
    EXPECT_THAT(judged("MAC460", "O9001\n" + twice), ElementsAre("note 5")); // nobody looks for it
    EXPECT_THAT(judged("MAC460", "O1\nM98 P9001\nG0 X1.\nO9001\nM30\n"), IsEmpty());
    EXPECT_THAT(judged("MAC460", "O9001\nIF[#1EQ2]GOTO5\nGOTO5\nG0 X1.\nHERE IT ENDS\nN5 M99\n"), IsEmpty());
}

TEST(SuspiciousTarget, IsAnAlarmOneDigitAway) {
    const auto program = [](const std::string& target, const std::string& block) {
        return "O9001\nIF[#26EQ#0]GOTO6\nN70 G0 X1.\nIF[#5003GE#26]GOTO" + target + "\nGOTO70\n" + block +
               "M99\nN6 #3000=1(Z)\nN8 M99\n";
    };
    EXPECT_THAT(messages_raised("MAC302", program("6", "N60 G0 Z50.\n")),
                ElementsAre(HasSubstr("'GOTO6' leads to line 8, and nothing leads to N60 on line 6")));
    EXPECT_THAT(lines_raised("MAC302", program("6", "N16 G0 Z50.\n")), ElementsAre(4));
    EXPECT_THAT(lines_raised("MAC302", program("6", "N61 G0 Z50.\n")), ElementsAre(4));
    EXPECT_THAT(judged("MAC302", program("60", "N60 G0 Z50.\n")), IsEmpty());
    EXPECT_THAT(judged("MAC302", program("8", "N80 G0 Z50.\n")), IsEmpty());    // no alarm there
    EXPECT_THAT(judged("MAC302", program("6", "N7 G0 Z50.\n")), IsEmpty());     // the next number
    EXPECT_THAT(judged("MAC302", program("6", "N600 G0 Z50.\n")), IsEmpty());   // two digits
    EXPECT_THAT(judged("MAC302", program("6", "N60 #3000=2(Z)\n")), IsEmpty()); // an alarm itself
}

TEST(SuspiciousTarget, IsTheLastJumpBeforeTheBlocks) {
    EXPECT_THAT(lines_raised("MAC302", "O9001\nIF[#26EQ#0]GOTO6\nIF[#25EQ#0]GOTO6\nIF[#24EQ#0]GOTO20\n"
                                       "GOTO20\nN60 G0 Z50.\nM99\nN20 M99\nN6 #3000=1(Z)\n"),
                ElementsAre(3));
}

TEST(UnreachableCode, IsExplainedByANumberThatIsMissing) {
    const std::string blocks = "N61 G0 Z5.\nN5 M99\n";
    EXPECT_THAT(judged("MAC460", "O9001\nIF[#1EQ2]GOTO60\nGOTO5\n" + blocks), IsEmpty());
    EXPECT_THAT(judged("MAC460", "O9001\nG65 P9002\nGOTO5\n" + blocks + "O9002\nM99 P60\n"), IsEmpty());
}

TEST(MissingProgramEnd, IsToldOfProgramsWithANumberThatMove) {
    EXPECT_THAT(judged("MAC455", "O1\nG0 X1.\n"), ElementsAre("error 2"));
    EXPECT_THAT(judged("MAC455", "G0 X1.\n"), IsEmpty());
    EXPECT_THAT(judged("MAC455", "O1\n#100=1\n"), IsEmpty());
    EXPECT_THAT(judged("MAC455", "O1\nG0 X1.\nO2\nX1.\nM30\n"), ElementsAre("error 2"));
}

TEST(MissingProgramEnd, IsANoteWhereNoAlarmOfTheControlIsKnown) {
    const auto workspace = test::analyse_text("nct", "O1\nG0 X1.\n");
    const auto findings = run_rules(*workspace, {{find_rule("MAC455")}}, 1);
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_EQ(findings[0].severity, Severity::note);
    EXPECT_THAT(findings[0].rule->why, HasSubstr("A note where no alarm of the control is known"));
}

TEST(MissingProgramEnd, MayStandInAnotherProgramOrABlockThatIsSkipped) {
    EXPECT_THAT(judged("MAC455", "O1\nG0 X1.\nM98 P9999\n"), IsEmpty());
    EXPECT_THAT(judged("MAC455", "O1\nG0 X1.\n/M30\n"), IsEmpty());
    // What follows has no number: it may be its own end.
    EXPECT_THAT(judged("MAC455", "O1\nG0 X1.\n<PART TWO>\nM30\n"), IsEmpty());
    EXPECT_THAT(judged("MAC455", "O1\nG0 X1.\nO2\nX1.\n<PART TWO>\nM30\n"), ElementsAre("error 2"));
    // MAC456 says more.
    EXPECT_THAT(judged("MAC455", "O1\nM98 P2\nG0 X1.\nM30\nO2\nX1.\n"), IsEmpty());
}

TEST(UnreachableCode, GoesOnBehindAnEndThatWasLeftInTheMiddle) {
    const std::string begin = "O1\nG90 G0 X0\nM30\n", rest = "G55 G0 X0\nG1 X10. F100.\nM30\n";
    EXPECT_THAT(judged("MAC460", begin + rest), ElementsAre("note 4"));
    EXPECT_THAT(messages_raised("MAC460", begin + rest), ElementsAre(HasSubstr("End in the middle")));
    for (const char* part : {"N5", "\n", "(SECOND PART)\n", "T2 M6\n"})
        EXPECT_THAT(judged("MAC460", begin + part + rest), IsEmpty()) << part;
    EXPECT_THAT(judged("MAC460", "O1\nG90 G0 X0\nM99\n" + rest), IsEmpty());
    EXPECT_THAT(judged("MAC460", "O1\rG90 G0 X0\rM30\rG55 G0 X0\rM30\r"), ElementsAre("note 4"));
    EXPECT_THAT(judged("MAC460", "O1\rG90 G0 X0\rM30\r\rG55 G0 X0\rM30\r"), IsEmpty());
}

} // namespace
} // namespace maclint
