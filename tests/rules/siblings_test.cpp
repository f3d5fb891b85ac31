//! Rules that compare statements with their neighbours, and jumps with the remarks beside them: MAC215,
//! MAC341.
#include "tests/rules/raised.hpp"

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

std::vector<std::uint32_t> crossed(const std::string& blocks) {
    return lines_raised("MAC215", "O9001\n" + blocks + "M99\n");
}

TEST(CrossedAxes, OfTwoStatementsOneTakesTheVariableOfTheOther) {
    EXPECT_THAT(crossed("#24=#5001+#24\n#25=#5002+#24\n"), ElementsAre(3));
    EXPECT_THAT(crossed("#24=#5001+#25\n#25=#5002+#25\n"), ElementsAre(2));
    EXPECT_THAT(crossed("#24=#5001+#24\n#25=#5002+#25\n#26=#5003+#25\n"), ElementsAre(4));
    EXPECT_THAT(crossed("#101=[#5041-#101]*#1\n#102=[#5042-#101]*#1\n"), ElementsAre(3));
    EXPECT_THAT(crossed("#24=#24*#1\n#25=#24*#2\n"), ElementsAre(3));
    EXPECT_THAT(messages_raised("MAC215", "O9001\n#24=#5001+#24\n#25=#5002+#24\nM99\n"),
                ElementsAre(AllOf(HasSubstr("'#25=#5002+#24'"), HasSubstr("Take #25"))));
}

TEST(CrossedAxes, AreNoneWhereEveryNumberFollows) {
    EXPECT_THAT(crossed("#24=#5001+#24\n#25=#5002+#25\n"), IsEmpty());
    EXPECT_THAT(crossed("#24=#5001+#1\n#25=#5002+#1\n"), IsEmpty());
    EXPECT_THAT(crossed("#24=#5001+#25\n#25=#5002+#24\n"), IsEmpty()); // an exchange
    EXPECT_THAT(crossed("#24=#24+#1\n#25=#24+#1\n"), IsEmpty());       // nothing tells the axis
}

TEST(CrossedAxes, AreOfLettersThatNameAxes) {
    EXPECT_THAT(crossed("#21=#21*#1\n#22=#21*#2\n"), ElementsAre(3)); // U and V
    EXPECT_THAT(crossed("#25=#25*#1\n#26=#25*#2\n"), ElementsAre(3)); // Y and Z
    EXPECT_THAT(crossed("#20=#20*#1\n#21=#20*#2\n"), IsEmpty());      // T and U
}

TEST(CrossedAxes, AreAlikeInEverythingElse) {
    const auto other = [](const std::string& first, const std::string& second) {
        return crossed("#24=" + first + "\n#25=" + second + "\n").size();
    };
    EXPECT_EQ(other("#24*2+#1", "#24*2+#2"), 1U);
    EXPECT_EQ(other("#24*2+#1", "#24*3+#2"), 0U);
    EXPECT_EQ(other("#5001+#24", "#5003+#24"), 0U);
    EXPECT_EQ(other("#5001+#24", "#5001+#24"), 0U);
    EXPECT_EQ(other("#5001+#24", "#5002-#24"), 0U);
    EXPECT_EQ(other("#5001+ABS[#24]", "#5002+ABS[#24]"), 1U);
    EXPECT_EQ(other("#5001+ABS[#24]", "#5002+SIN[#24]"), 0U);
    EXPECT_EQ(other("#5001+#24+#7", "#5002+#24+#8"), 1U);
    EXPECT_EQ(other("#5001+#24+#7", "#5002+#24+#9"), 0U);
    EXPECT_EQ(other("#5001+#24+#24", "#5002+#24+#25"), 1U);
    EXPECT_EQ(other("#5001+#24+#24", "#5002+#24+#24"), 0U); // which of the two is meant is not clear
    EXPECT_EQ(other("#5001+#24", "#5002+#26"), 0U);
}

TEST(CrossedAxes, AreNoSums) {
    EXPECT_THAT(crossed("#101=#101+#501\n#102=#101+#502\n"), IsEmpty());
    EXPECT_THAT(crossed("#24=#5001+#24\nG0X#24\n#25=#5002+#24\n"), IsEmpty());
    EXPECT_THAT(crossed("#24=#5001+#24\n#26=#5003+#24\n"), IsEmpty());
}

TEST(CrossedAxes, AreOffsetsOfTwoAxesThatTakeOnePosition) {
    EXPECT_THAT(crossed("#5221=#5221+#5061\n#5222=#5222+#5061\n"), ElementsAre(3));
    EXPECT_THAT(crossed("#5221=#5221+#5062\n#5222=#5222+#5062\n"), ElementsAre(2));
    EXPECT_THAT(messages_raised("MAC215", "O9001\n#5222=#5042-#25\n#5223=#5042-#26\nM99\n"),
                ElementsAre(AllOf(HasSubstr("'#5223=#5042-#26' is made of #5042"), HasSubstr("Take #5043"))));
    EXPECT_THAT(crossed("#5221=#5221+#5061\n#5222=#5222+#5062\n"), IsEmpty());
    EXPECT_THAT(crossed("#5221=#5221+#5063\n#5222=#5222+#5063\n"), IsEmpty()); // neither's own
    EXPECT_THAT(crossed("#5240=#5061\n#5241=#5061\n"), IsEmpty());             // of two offsets
    EXPECT_THAT(crossed("#101=#5061\n#102=#5061\n"), IsEmpty());               // nothing tells the axis
}

std::vector<std::string> other_cases(const std::string& blocks) {
    return messages_raised("MAC215", "O9001\n" + blocks + "G0 X#31 Y#32\nM99\n");
}

TEST(OffsetOfAnotherCase, IsTakenInAConditionThatAsksForOne) {
    const std::string own = "IF[#4014EQ54]THEN #31=#5221\nIF[#4014EQ56]THEN #31=#5261\n";
    EXPECT_THAT(other_cases(own + "IF[#4014EQ54]THEN #32=#5262\n"),
                ElementsAre(AllOf(HasSubstr("#5262 belongs to G56"), HasSubstr("in the case for G54"),
                                  HasSubstr("Take #5222"))));
    EXPECT_THAT(other_cases(own + "IF[#4014EQ54]THEN #32=#5222\n"), IsEmpty());
    // Programs in the wild ask #4012 for it.
    EXPECT_THAT(other_cases("IF[#4012EQ54]THEN #31=#5221\nIF[#4012EQ56]THEN #31=#5261\n"
                            "IF[#4012EQ57]THEN #31=#5261\n"),
                ElementsAre(HasSubstr("in the case for G57")));
    // As many take another's as their own: numbers of which nobody knows what they mean there.
    EXPECT_THAT(other_cases("IF[#4014EQ54]THEN #31=#5221\nIF[#4014EQ56]THEN #31=#5241\n"), IsEmpty());
    // From one offset to another.
    EXPECT_THAT(other_cases(own + "IF[#4014EQ54]THEN #5221=#5261\n"), IsEmpty());
    EXPECT_THAT(other_cases(own + "IF[#4014EQ54]THEN #32=#5222-#5262\n"), IsEmpty());
}

TEST(OffsetOfAnotherCase, IsTakenInABranch) {
    const std::string branches =
        "#30=#4014\nIF[#30EQ54]GOTO54\nIF[#30NE55]GOTO9\n#31=#5241\n#32=#5242\nGOTO9\n"
        "N54 #31=#5221\nG4 X1.\n";
    EXPECT_THAT(other_cases(branches + "#32=#5242\nN9 G4 X1.\n"),
                ElementsAre(HasSubstr("in the case for G54")));
    EXPECT_THAT(other_cases(branches + "#32=#5222\nN9 G4 X1.\n"), IsEmpty());
    // Behind the place where the branches meet no case is asked for.
    EXPECT_THAT(other_cases(branches + "N9 #33=#5263\n"), IsEmpty());
    // What is no copy of the code alone says nothing.
    EXPECT_THAT(other_cases("#30=#1\n" + branches + "#32=#5242\nN9 G4 X1.\n"), IsEmpty());
}

/// Behind two blocks N3 and N4, before N5 and N6.
std::vector<std::string> beside(const std::string& blocks) {
    return judged("MAC341", "O9341\nN3 #1=1\nN4 G4 X1.\n" + blocks + "N5 G4 X1.\nN6 M99\n");
}

TEST(RemarkOfAJump, NamesAnotherBlock) {
    EXPECT_THAT(beside("IF[#1EQ1]GOTO3\n(SENSOR ON, GO TO N5)\n"), ElementsAre("note 4"));
    EXPECT_THAT(beside("IF[#1EQ1]GOTO3 (goto 0005)\n"), ElementsAre("note 4"));
    EXPECT_THAT(beside("(NO TOOL: GOTO N6)\nIF[#1EQ1]GOTO5\n"), ElementsAre("note 5"));
    EXPECT_THAT(beside("IF[#1EQ1]GOTO3\nIF[#1EQ2]GOTO6\n(ON: GO TO N3)\n(OFF: GO TO N5)\n"),
                ElementsAre("note 5"));
    EXPECT_THAT(messages_raised("MAC341", "O1\nN3 #1=1\nIF[#1EQ1]GOTO3 (GO TO N5)\nN5 M30\n"),
                ElementsAre(AllOf(HasSubstr("'GOTO3' goes to N3"), HasSubstr("says N5"))));
    for (const std::string end : {"\r", "\r\n"}) {
        const std::string program =
            "O1" + end + "N3 #1=1" + end + "IF[#1EQ1]GOTO3" + end + "(ON, GO TO N5)" + end;
        EXPECT_THAT(judged("MAC341", program + "N5 M30" + end), ElementsAre("note 3"));
    }
}

TEST(RemarkOfAJump, NamesItsBlock) {
    EXPECT_THAT(beside("IF[#1EQ1]GOTO5\n(SENSOR ON, GO TO N5)\n"), IsEmpty());
    EXPECT_THAT(beside("IF[#1EQ1]GOTO3\nIF[#1EQ2]GOTO6\n(ON: GO TO N3)\n(OFF: GO TO N006)\n"), IsEmpty());
    // Of two, one speaks of a jump that is gone.
    EXPECT_THAT(beside("IF[#1EQ1]GOTO5\n(LOW: GO TO N6)\n(ON: GO TO N5)\n"), IsEmpty());
    EXPECT_THAT(beside("IF[#1EQ1]GOTO5\n(GO TO N77)\n"), IsEmpty());      // no block bears the number
    EXPECT_THAT(beside("IF[#1EQ1]GOTO5\n(IF[#1EQ2]GOTO3)\n"), IsEmpty()); // a block that is switched off
    EXPECT_THAT(beside("IF[#1EQ1]GOTO5\n(GO TO N3 OR GO TO N4)\n"), IsEmpty()); // says more
    EXPECT_THAT(beside("IF[#1EQ1]GOTO5\nG4 X1.\n(GO TO N3)\n"), IsEmpty());     // not beside it
}

} // namespace
} // namespace maclint
