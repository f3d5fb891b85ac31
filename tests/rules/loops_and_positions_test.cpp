//! Slips in loops and positions, each beside what is right.
#include "tests/rules/raised.hpp"
#include "tests/support/linted.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using test::lines_raised;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(LoopThatOnlyAnAlarmEnds, DoesNotChangeWhatItCounts) {
    const auto told = [](const std::string& counts) {
        return lines_raised("MAC319", "O9812\n#29=0\nWHILE[#29LT2]DO1\nG31X[#29*#24]F100.\n"
                                      "IF[#5061GT#25]THEN#3000=1(TOO FAR)\n" +
                                          counts + "END1\nM99\n");
    };
    EXPECT_THAT(told(""), ElementsAre(3));
    EXPECT_THAT(told("#29=#29+1\n"), IsEmpty());
}

TEST(InnerLoopRunOnce, AlsoWhereItsLimitOnlyFalls) {
    const auto told = [](const std::string& between, const std::string& step) {
        return lines_raised("MAC321",
                            "O8500\n#32=5\nWHILE[#32GT0]DO1\n#32=#32" + step + "\n#30=1\n" + between +
                                "WHILE[#29LT#32]DO2\n#30=#30*10\n#29=#29+1\nEND2\nG0X#30\nEND1\nM99\n");
    };
    EXPECT_THAT(told("", "-1"), ElementsAre(6));
    EXPECT_THAT(told("#29=0\n", "-1"), IsEmpty());
    EXPECT_THAT(told("", "+1"), IsEmpty()); // it runs on where it has stopped
}

TEST(CountedTry, JumpsBackInFrontOfItsFirstNumber) {
    const auto told = [](const std::string& target) {
        return lines_raised("MAC718", "O8312(MAX 5 TRIES)\nN1#3=0\nN2M10\nG4P500\nIF[#1010EQ1]GOTO9\nM11\n"
                                      "#3=#3+1\nIF[#3LT5]GOTO" +
                                          target + "\n#3000=12(CLAMP)\nN9M99\n");
    };
    EXPECT_THAT(told("1"), ElementsAre(8));
    EXPECT_THAT(told("2"), IsEmpty());
}

TEST(LoopWithoutEffect, IsLeftWithACountThatNobodyReads) {
    const auto told = [](const std::string& loop, const std::string& behind) {
        return lines_raised("MAC342", "O9400\n#10=0\nN1#10=#10+#17\n" + loop + "\n" + behind + "M99\n");
    };
    EXPECT_THAT(told("IF[#10LE#26]GOTO1", "#10=#26\nG1Z-#10F#9\n"), ElementsAre(4));
    EXPECT_THAT(told("IF[#10LE#26]GOTO1", "G1Z-#10F#9\n"), IsEmpty());
    EXPECT_THAT(told("G1Z-#10F#9\nIF[#10LE#26]GOTO1", "#10=#26\nG1Z-#10F#9\n"), IsEmpty()); // it cuts
    EXPECT_THAT(told("IF[#1000EQ0]GOTO1", "#10=#26\nG1Z-#10F#9\n"), IsEmpty());             // it waits
    EXPECT_THAT(told("IF[#10LE[#5043+#26]]GOTO1", "#10=#26\nG1Z-#10F#9\n"),
                IsEmpty()); // until an axis is there
    const std::string common = "O9400\nN1#510=#510+#17\nIF[#510LE#26]GOTO1\nM99\n";
    EXPECT_THAT(lines_raised("MAC342", common), IsEmpty()); // others read it
}

TEST(PositionForATouch, StandsBesideAnotherTouch) {
    const auto told = [](const std::string& second, const std::string& taken) {
        return lines_raised("MAC615", "O9814\nG31X-9.F80.\n#12=#5061\nG0X0\nG31X9.F80.\n#13=" + second +
                                          "\nG0X0\n#138=" + taken + "\nM99\n");
    };
    EXPECT_THAT(told("#5041", "#13-#12"), ElementsAre(6));
    EXPECT_THAT(told("#5061", "#13-#12"), IsEmpty());
    EXPECT_THAT(told("#5042", "#13-#12"), IsEmpty());   // of another axis
    EXPECT_THAT(told("#5041", "#13+#12/2"), IsEmpty()); // nothing is taken away
    const std::string one_move = "O9814\nG31X-9.F80.\n#12=#5061\n#13=#5041\n#138=#13-#12\nM99\n";
    EXPECT_THAT(lines_raised("MAC615", one_move), IsEmpty()); // how far it runs on
}

TEST(PositionsOfTwoKinds, CountFromTwoZeros) {
    const auto told = [](const std::string& blocks) {
        return lines_raised("MAC230", "O9230\n" + blocks + "M99\n");
    };
    EXPECT_THAT(told("#5221=#5021-10.\n#5222=#5042-10.\n"), ElementsAre(3));
    EXPECT_THAT(told("#5221=#5021-10.\n#5222=#5022-10.\n"), IsEmpty());
    EXPECT_THAT(told("#5221=#5021-10.\n#5242=#5042\n"), IsEmpty()); // of another offset
    EXPECT_THAT(told("G90G10L2P1X#5021Y#5042\n"), ElementsAre(2));
    EXPECT_THAT(told("#1=#5021\nG28G91Z0\nG90G0X#1\n"), ElementsAre(4));
    EXPECT_THAT(told("#1=#5041\nG28G91Z0\nG90G0X#1\n"), IsEmpty());
    EXPECT_THAT(told("#1=#5021\nG28G91Z0\nG90G53G0X#1\n"), IsEmpty());
    EXPECT_THAT(told("#1=#5041\nG28G91Z0\nG90G53G0X#1\n"), ElementsAre(4));
    EXPECT_THAT(told("#1=#5023\nG31Z-9.F50.\n#2=#5063\n#3=#1-#2\n"), ElementsAre(5));
    EXPECT_THAT(told("#1=#5043\nG31Z-9.F50.\n#2=#5063\n#3=#1-#2\n"), IsEmpty());
    EXPECT_THAT(told("#1=#5023\n#2=#5043\n#3=#1-#2\nG31Z-9.F50.\n"), IsEmpty()); // the offsets between them
}

TEST(PositionAsAnIncrement, MayHaveArgumentsTakenFromIt) {
    const auto told = [](const std::string& word) {
        return lines_raised("MAC536",
                            "O9536\n#10=#5041\n#14=#24/3\nG91G0Y#14\nG1" + word + "F#9\nG90\nM99\n");
    };
    EXPECT_THAT(told("X[#10-#7/2-3.]"), ElementsAre(5));
    EXPECT_THAT(told("X[#24-#10]"), IsEmpty());
    EXPECT_THAT(told("X[#10-#14]"), IsEmpty()); // who knows what it is
}

TEST(NumberOfAVariable, IsComparedWithALimit) {
    const auto told = [](const std::string& counter, const std::string& condition) {
        return lines_raised("MAC233", "O9600\n#1=" + counter + "\n#[#1]=#[#1]+1\nIF[" + condition +
                                          "]GOTO9\n#[#1]=0\nN9M99\n");
    };
    EXPECT_THAT(told("600+#20", "#1LT#11"), ElementsAre(4));
    EXPECT_THAT(told("600+#20", "#[#1]LT#11"), IsEmpty());
    EXPECT_THAT(told("600+#20", "#1EQ#11"), IsEmpty()); // the number of one
    EXPECT_THAT(told("#20", "#1LT#11"), IsEmpty());
    EXPECT_THAT(told("600+#20\n#1=#1+1", "#1LT#11"), IsEmpty()); // it counts through a list
}

TEST(NumberForAVariable, StandsInACalculationOfNumbers) {
    const auto told = [](const std::string& value) {
        return lines_raised("MAC229",
                            "O9851\nIF[#19LE0]GOTO9\nM4S" + value + "\nG0X#24\nM99\nN9#3000=1(S)\n");
    };
    EXPECT_THAT(told("[3800/19]"), ElementsAre(3));
    EXPECT_THAT(told("[3800/#19]"), IsEmpty());
    EXPECT_THAT(told("[3800/#24*19]"), IsEmpty()); // a number among variables
    EXPECT_THAT(told("[3800/20]"), IsEmpty());
}

TEST(IndexSetInFrontOfIt, LeadsToNoArgument) {
    const std::string macro = "O9600\n#1=600+#20\n#[#1]=#[#1]+1\nG0X#[#1]\nM99\n";
    const auto told = [&](const std::string& call) {
        return lines_raised("MAC211", "O0001\nG65P9600" + call + "\nM30\n" + macro);
    };
    EXPECT_THAT(told("T8.H500."), ElementsAre(2));
    EXPECT_THAT(told("T8."), IsEmpty());
    EXPECT_THAT(told("T8.H#0"), IsEmpty()); // passes nothing
}

TEST(TouchThatNobodyAsksFor, IsUsedBehindAConditionOfAnotherMatter) {
    const auto told = [](const std::string& asks) {
        return lines_raised("MAC607",
                            "O9832\n#3=#5043\nG31Z#26F50.\n#5=#5063\n" + asks +
                                "G0Z#3\nIF[#19EQ#0]GOTO10\n#5223=#5223+#5\nN10M99\nN20#3000=20(NONE)\n");
    };
    EXPECT_THAT(told(""), ElementsAre(3));
    EXPECT_THAT(told("IF[ABS[#5-#26]LT.002]GOTO20\n"), IsEmpty());
}

TEST(TouchThatNobodyAsksFor, IsUsedWithOneThatSomebodyDoes) {
    const auto told = [](const std::string& second) {
        return lines_raised("MAC607",
                            "O9494\nG90G31X#5F80.\nG53\nIF[ABS[#5041-#5]LT.01]GOTO101\n#8=#5061\nG0X#4\n"
                            "G31X#6F80.\nG53\n" +
                                second + "#9=#5061\n#138=[#8+#9]/2\nG0X#4\nM99\nN101#3000=101(WALL)\n");
    };
    EXPECT_THAT(told(""), ElementsAre(7));
    EXPECT_THAT(told("IF[ABS[#5041-#6]LT.01]GOTO101\n"), IsEmpty());
    const std::string later = "IF[#9GT50.]GOTO101\n";
    EXPECT_THAT(
        lines_raised("MAC607", "O9494\nG90G31X#5F80.\nIF[ABS[#5041-#5]LT.01]GOTO101\n#8=#5061\nG0X#4\n"
                               "G31X#6F80.\n#9=#5061\n" +
                                   later + "#138=[#8+#9]/2\nM99\nN101#3000=101(WALL)\n"),
        IsEmpty());
}

TEST(UnreachedAlarm, RetractsInFrontOfIt) {
    const auto told = [](const std::string& retract) {
        return lines_raised("MAC460", "O9832\nG31Z#26F50.\nM99\nN20" + retract + "\n#3000=20(NONE)\n");
    };
    EXPECT_THAT(told("G0Z50."), ElementsAre(4));
    EXPECT_THAT(told(""), IsEmpty()); // kept for later
}

} // namespace
} // namespace maclint
