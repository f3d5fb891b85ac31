//! Rules on values that are stored and lost, kept or calculated again: MAC213, MAC214, MAC216, MAC720.
#include "tests/rules/raised.hpp"
#include "tests/support/linted.hpp"

#include <gmock/gmock.h>

namespace maclint {
namespace {

using test::judged;
using test::lines_raised;
using test::messages_raised;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<std::string> codes_of(const std::vector<test::LintedText>& texts, const std::string& rule) {
    cli::Overrides overrides;
    overrides.select = {rule};
    return test::codes(test::lint_texts(texts, overrides));
}

std::vector<std::string> dead(const std::string& blocks) {
    return judged("MAC213", "O9001(A B X)\n" + blocks + "M99\n");
}

TEST(DeadStore, IsReplacedOnEveryPath) {
    EXPECT_THAT(dead("#33=#1-#2\n#33=#24\nG0X#33\n"), ElementsAre("warning 2"));
    EXPECT_THAT(dead("#33=#1-#2\nIF[#1GT5]GOTO5\n#33=#24\nGOTO6\nN5#33=#2\nN6G0X#33\n"),
                ElementsAre("warning 2"));
    EXPECT_THAT(dead("#33=#1-#2\nIF[#1GT5]GOTO5\n#33=#24\nN5G0X#33\n"), IsEmpty());
    EXPECT_THAT(dead("#33=#1-#2\n/#33=#24\nG0X#33\n"), IsEmpty());
    // Under a condition whose other side leads elsewhere: nobody meant it as a special case.
    EXPECT_THAT(dead("IF[#1EQ1]GOTO9\n#33=#1-#2\n#33=#24\nG0X#33\nN9\n"), ElementsAre("warning 3"));
    EXPECT_THAT(messages_raised("MAC213", "O9001(A B X)\n#33=#1-#2\n#33=#24\nG0X#33\nM99\n"),
                ElementsAre(AllOf(HasSubstr("'#33=#1-#2'"), HasSubstr("line 3"))));
}

TEST(DeadStore, IsANoteWhereNothingFollowsThatReads) {
    EXPECT_THAT(dead("G0X#1\n#1=#24-#2\n"), ElementsAre("note 3"));
    EXPECT_THAT(dead("#33=#24-#2\nG0X#1\n"), ElementsAre("note 2"));
    EXPECT_THAT(dead("G0X#24\nIF[#1EQ1]THEN#30=#24*2\nIF[#1EQ2]THEN#30=#24*3\n"),
                ElementsAre("note 3", "note 4"));
    EXPECT_THAT(messages_raised("MAC213", "O9001(X)\n#33=#24*2\nG0X#24\nM99\n"),
                ElementsAre(HasSubstr("no block reads it")));
}

TEST(DeadStore, IsNoneInFrontOfALoopThatNothingEnds) {
    EXPECT_THAT(dead("IF[#1EQ1]GOTO5\n#33=#1-#2\nN1G0X0\nGOTO1\nN5#33=#24*2\nG0X#33\n"), IsEmpty());
}

TEST(DeadStore, IsNoneOfNumbersThatSomebodyEdits) {
    EXPECT_THAT(dead("#33=5.\n#33=#24\nG0X#33\n"), IsEmpty());
    EXPECT_THAT(dead("#33=40./2\n#33=#24\nG0X#33\n"), IsEmpty());
    EXPECT_THAT(dead("#33=#0\n#33=#24\nG0X#33\n"), IsEmpty());
    EXPECT_THAT(dead("#8=50(R POINT)\nG0X#24\n"), IsEmpty());
}

TEST(DeadStore, IsNoneWhereSomebodyElseMayRead) {
    // the callee shares the locals, or reads the common variable
    EXPECT_THAT(dead("#33=#1-#2\nM98P9002\n#33=#24\nG0X#33\n"), IsEmpty());
    EXPECT_THAT(dead("#100=#1-#2\nG65P9002\n#100=#24\nG0X#100\n"), IsEmpty());
    // a display
    EXPECT_THAT(dead("#500=#1-#2\nM00\n#500=#24\nG0X#500\n"), IsEmpty());
    EXPECT_THAT(dead("#500=#1-#2\n"), IsEmpty());
    EXPECT_THAT(dead("#500=#1-#2\n#501=#24\n#500=#24\nG0X#500\n"), ElementsAre("warning 2"));
    EXPECT_THAT(dead("#500=#1\n#501=#24\n#500=#24\nG0X#500\n"), IsEmpty()); // #1 has it still
    EXPECT_THAT(dead("#33=#1-#2\n#32=#[30+#24]\n#33=#24\nG0X#33Y#32\n"), IsEmpty());
    EXPECT_THAT(dead("#33=#1-#2\nDPRNT[#33[53]]\n#33=#24\nG0X#33\n"), IsEmpty());
}

TEST(DeadStore, IsNoneInWhatACallerShares) {
    const test::LintedText callee{"2.nc", "O9001\n#33=#1*2\nM99\n"};
    EXPECT_THAT(codes_of({{"1.nc", "O0001\nG0X0\n#1=2\nM98P9001\nG0X#33\nM30\n"}, callee}, "MAC213"),
                IsEmpty());
    EXPECT_THAT(codes_of({{"1.nc", "O0001\nG0X0\nG65P9001A2\nM30\n"}, callee}, "MAC213"),
                ElementsAre("MAC213"));
}

TEST(DeadStore, IsANoteWhereTheReaderIsSwitchedOff) {
    EXPECT_THAT(dead("#33=#1-#2\nGOTO5(DELETE TO ENABLE)\nG0X#33\nN5G0X#24\n"), ElementsAre("note 2"));
}

TEST(DeadStore, IsNoCopyThatNothingUsesYet) {
    EXPECT_THAT(dead("#33=#24\nG0X#24\n"), IsEmpty());
    EXPECT_THAT(dead("#33=#5001\nG0X#24\n"), IsEmpty());
    EXPECT_THAT(dead("IF[#1EQ0]THEN#33=#24*2\n#33=#24\nG0X#24\n"), ElementsAre("note 2"));
}

TEST(DeadStore, IsACopyWhoseSourceIsSetAnew) {
    EXPECT_THAT(dead("#500=#1\n#500=#24\nG0X#1\n"), IsEmpty());
    EXPECT_THAT(dead("#500=#1\n#1=7\n#500=#24\nG0X#1\n"), ElementsAre("warning 2"));
    EXPECT_THAT(dead("#1=7\n#500=#1\n#500=#24\n#1=8\nG0X#1\n"), IsEmpty());
    EXPECT_THAT(dead("#500=#1\nIF[#2EQ1]THEN#1=7\n#500=#24\nG0X#1\n"), ElementsAre("warning 2"));
    EXPECT_THAT(dead("#500=#1\n#2=7\n#500=#24\nG0X#2\n"), IsEmpty());
}

TEST(DeadStore, IsNoCounterNorSavedCodeNorRepetition) {
    EXPECT_THAT(dead("#33=0\nG0X#33\n#33=#33+1\nG0X#1\n"), IsEmpty());
    EXPECT_THAT(dead("#33=#4003\n#33=#24\nG0X#33\n"), IsEmpty());
    EXPECT_THAT(dead("#33=#1-#2\n#33=#1-#2\nG0X#33\n"), IsEmpty());
}

std::vector<std::uint32_t> lost(const std::string& blocks) {
    return lines_raised("MAC214", "O9001(A B X)\n" + blocks + "M99\n");
}

TEST(OverwrittenConditional, IsSetBeforeItsGeneralCase) {
    EXPECT_THAT(lost("IF[#1EQ0]THEN#33=360\n#33=#24\nG0X#33\n"), ElementsAre(2));
    EXPECT_THAT(lost("IF[#1NE0]GOTO5\n#33=#2\nN5#33=#24\nG0X#33\n"), ElementsAre(3));
    // the tests between send the program elsewhere
    EXPECT_THAT(lost("IF[#2EQ#0]GOTO1\nIF[#2LE0]GOTO9\n#33=#2\nN2\nN1#33=#24\nN3G0X#33\nM99\nN9\n"),
                ElementsAre(4));
    EXPECT_THAT(dead("IF[#1EQ0]THEN#33=#2\n#33=#24\nG0X#33\n"), IsEmpty()); // said once
}

TEST(OverwrittenConditional, IsDecidedByATestSixtyFourBlocksBeforeAtMost) {
    const auto behind = [](int blocks) {
        std::string text = "IF[#1NE0]GOTO5\n";
        for (int i = 1; i < blocks; ++i) text += "#32=#32+1\n";
        return lost(text + "#33=#2\nN5#33=#24\nG0X#33Y#32\n").size();
    };
    EXPECT_EQ(behind(1), 1U);
    EXPECT_EQ(behind(64), 1U);
    EXPECT_EQ(behind(65), 0U);
}

TEST(OverwrittenConditional, IsNoneWhereTheCaseIsKept) {
    EXPECT_THAT(lost("#33=#24\nIF[#1EQ0]THEN#33=360\nG0X#33\n"), IsEmpty());
    EXPECT_THAT(lost("IF[#1EQ0]THEN#33=360\nIF[#1NE0]THEN#33=#24\nG0X#33\n"), IsEmpty());
    EXPECT_THAT(lost("IF[#1NE0]GOTO5\n#33=360\nGOTO6\nN5#33=#24\nN6G0X#33\n"), IsEmpty());
    EXPECT_THAT(lost("WHILE[#1LT3]DO1\n#1=#1+1\n#33=#24*#1\nEND1\n#33=#2\nG0X#33\n"), IsEmpty());
}

TEST(OverwrittenConditional, IsNoMissingBreak) {
    const std::string head = "MACHINING\nN10 INPUT(\"Size\",#l1)\nN20 SWITCH #l1\nN30 CASE 1\nN40 #l2=26\n";
    const std::string tail =
        "N60 CASE 2\nN70 #l2=34\nN80 BREAK\nN90 ENDSWITCH\nN100 G0 X#l2\nN110 M30\nEND\n";
    EXPECT_THAT(codes_of({{"ring.nc", head + tail}}, "MAC214"), IsEmpty());
}

std::vector<std::uint32_t> stale(const std::string& blocks) {
    return lines_raised("MAC216", "O9001\n" + blocks + "M99\n");
}
const std::string allowed = "IF[#4012EQ54]GOTO1\nIF[#4012EQ55]GOTO1\nIF[#4012EQ56]GOTO1\n#3000=1(G)\nN1\n";

TEST(CommonStaleRead, IsOfACaseThatIsAllowedAndNotSet) {
    EXPECT_THAT(stale(allowed + "IF[#4012EQ54]THEN#103=3\nIF[#4012EQ56]THEN#103=2\nG0X#103\n"),
                ElementsAre(9));
    EXPECT_THAT(messages_raised("MAC216", "O9001\n" + allowed +
                                              "IF[#4012EQ54]THEN#103=3\nIF[#4012NE56]GOTO5\n#103=2\n"
                                              "N5G0X#103\nM99\n"),
                ElementsAre(AllOf(HasSubstr("#4012 = 54, 56"), HasSubstr("for 55"))));
}

TEST(CommonStaleRead, IsNoneWithoutThatEvidence) {
    const std::string cases = "IF[#4012EQ54]THEN#103=3\nIF[#4012EQ56]THEN#103=2\n";
    EXPECT_THAT(stale(cases + "G0X#103\n"), IsEmpty()); // nobody asks for another number
    EXPECT_THAT(stale(allowed + "#103=1\n" + cases + "G0X#103\n"), IsEmpty());
    EXPECT_THAT(stale(allowed + "IF[#4012EQ54]THEN#103=3\nG0X#103\n"),
                IsEmpty()); // a setting with one exception
    EXPECT_THAT(stale(allowed + "IF[#4012EQ54]THEN#503=3\nIF[#4012EQ56]THEN#503=2\nG0X#503\n"), IsEmpty());
    EXPECT_THAT(stale(allowed + cases + "IF[#103EQ#0]GOTO9\nN9\n"), IsEmpty());
    EXPECT_THAT(stale(allowed + cases + "IF[#4012EQ55]GOTO9\nG0X#103\nN9\n"), IsEmpty());
    EXPECT_THAT(stale(allowed + "G65P9002\n" + cases + "G0X#103\n"), IsEmpty());
}

TEST(CommonStaleRead, IsNoneWhereTheSubjectChangesInBetween) {
    const std::string allowed_argument = "IF[#1EQ4]GOTO1\nIF[#1EQ5]GOTO1\nIF[#1EQ6]GOTO1\n#3000=1(A)\nN1\n";
    const std::string cases = "IF[#1EQ4]THEN#103=3\nIF[#1EQ6]THEN#103=2\nG0X#103\n";
    EXPECT_THAT(stale(allowed_argument + cases), ElementsAre(9));
    EXPECT_THAT(stale(allowed_argument + "#1=#2\n" + cases), IsEmpty());
}

TEST(CommonStaleRead, IsNoneWhereACallerSetsIt) {
    const std::string macro =
        "O9001\n" + allowed + "IF[#4012EQ54]THEN#103=3\nIF[#4012EQ56]THEN#103=2\nG0X#103\nM99\n";
    const auto with = [&](const std::string& caller) {
        return codes_of({{"1.nc", "O0001\n" + caller + "G65P9001\nM30\n"}, {"2.nc", macro}}, "MAC216");
    };
    EXPECT_THAT(with("#103=1\n"), IsEmpty());
    EXPECT_THAT(with("#104=1\n"), ElementsAre("MAC216"));
}

/// A limit, an alarm behind it; `rest` stands between them.
std::vector<std::uint32_t> early(const std::string& limit, const std::string& rest) {
    return stale("IF[#26LE0]GOTO9\n" + limit + "\n" + rest + "M99\nN9#3000=1(Z)\n");
}

TEST(CommonStaleRead, IsInALimitThatIsCheckedBeforeTheVariableIsSet) {
    const std::string set = "#106=#26-#18\n", used = "G1Z-#106\n";
    EXPECT_THAT(early("IF[#106+#23GT80.]GOTO9", set + used), ElementsAre(3));
    EXPECT_THAT(early("IF[#106LE80.]GOTO5\nGOTO9\nN5", set + used), ElementsAre(3));
    EXPECT_THAT(
        messages_raised("MAC216", "O9001\nIF[#106GT80.]GOTO9\n#106=#26-#18\nZ#106\nM99\nN9#3000=1(Z)\n"),
        ElementsAre(AllOf(HasSubstr("'IF[#106GT80.]GOTO9' looks at #106"), HasSubstr("line 3"))));
}

TEST(CommonStaleRead, IsNoLimitThatIsMeantForTheRunBefore) {
    const std::string set = "#106=#26-#18\n", used = "G1Z-#106\n";
    const std::string limit = "IF[#106+#23GT80.]GOTO9";
    EXPECT_THAT(early(limit, used + set), IsEmpty());                       // it is used before, too
    EXPECT_THAT(early(limit, set), IsEmpty());                              // kept for another program
    EXPECT_THAT(early(limit, "#106=#26\n" + used), IsEmpty());              // a copy
    EXPECT_THAT(early(limit, "#106=0\n" + used), IsEmpty());                // a state
    EXPECT_THAT(early(limit, "#106=#106+#26\n" + used), IsEmpty());         // a sum over the runs
    EXPECT_THAT(early(limit, set + set + used), IsEmpty());                 // several assignments
    EXPECT_THAT(early("IF[#106GT#26]GOTO9", set + used), IsEmpty());        // deeper than the last time
    EXPECT_THAT(early("IF[#106GT80.]GOTO7", set + "N7" + used), IsEmpty()); // no alarm
    EXPECT_THAT(early(set + limit, used), IsEmpty());                       // it is set before
    EXPECT_THAT(early("IF[#506GT80.]GOTO9", "#506=#26-#18\nG1Z-#506\n"), IsEmpty());
}

TEST(CommonStaleRead, IsNoLimitOfWhatACallerSets) {
    const std::string macro = "O9001\nIF[#106GT80.]GOTO9\n#106=#26-#18\nG1Z-#106\nM99\nN9#3000=1(Z)\n";
    const auto with = [&](const std::string& caller) {
        return codes_of({{"1.nc", "O0001\n" + caller + "G65P9001Z5.R1.\nM30\n"}, {"2.nc", macro}}, "MAC216");
    };
    EXPECT_THAT(with("#106=1\n"), IsEmpty());
    EXPECT_THAT(with("#104=1\n"), ElementsAre("MAC216"));
}

std::vector<std::uint32_t> again(const std::string& blocks) {
    return lines_raised("MAC720", "O9001(A B X)\n" + blocks + "M99\n");
}

TEST(RedundantRecompute, IsWhatTheVariableHolds) {
    EXPECT_THAT(again("#33=#1-#2\nG0X#33\n#33=#1-#2\nG0Y#33\n"), ElementsAre(4));
    EXPECT_THAT(again("#33=#1-#2\nG0X#33\n#1=#24\n#33=#1-#2\nG0Y#33\n"), IsEmpty());
    EXPECT_THAT(again("#33=#1-#2\nG0X#33\n#33=#24\nG0X#33\n#33=#1-#2\nG0Y#33\n"), IsEmpty());
    EXPECT_THAT(again("#33=#5001-#2\nG0X#33\n#33=#5001-#2\nG0Y#33\n"), IsEmpty());
    // an operator measures and corrects while the program stands
    EXPECT_THAT(again("#33=#1-#500\nG0X#33\nM00\n#33=#1-#500\nG0Y#33\n"), IsEmpty());
    EXPECT_THAT(again("#33=5\nG0X#33\n#33=5\nG0Y#33\n"), IsEmpty());
    EXPECT_THAT(again("IF[#1GT1]GOTO5\n#33=#1-#2\nG0X#33\nN5#33=#1-#2\nG0Y#33\n"), IsEmpty());
}

} // namespace
} // namespace maclint
