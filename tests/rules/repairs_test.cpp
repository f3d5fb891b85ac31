//! What authors have repaired in their macros, and what stands close to it and is right.
#include "analyzer/dialect/dialect.hpp"
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

std::vector<Finding> findings(std::string_view code, std::string text) {
    return run_rules(*test::analyse_text("fanuc", std::move(text)), {{find_rule(code)}}, 1);
}

TEST(CallsWithNumbers, CountWhatTheControlSurelyHas) {
    const std::string macro = "M30\nO9801\nIF[#24GT50]THEN#3000=1(X)\nG0X#24\nM99\n";
    const auto told = findings("MAC470", "O1\nG65P9801X100.\n" + macro);
    ASSERT_THAT(told, SizeIs(1));
    EXPECT_THAT(told.front().message(), HasSubstr("the value of #24 (X)"));
    EXPECT_THAT(findings("MAC470", "O1\nG65P9801X100\n" + macro), IsEmpty()) << "0.1 without a point";
    EXPECT_THAT(findings("MAC470", "O1\nG65P9801X50.\n" + macro), IsEmpty());
    const std::string sum = "M30\nO9802\nIF[#1GT.3]THEN#3000=1(A)\nG0X#1\nM99\n";
    EXPECT_THAT(findings("MAC470", "O1\n#1=.1\n#1=#1+.1\n#1=#1+.1\nG65P9802A#1\n" + sum), IsEmpty())
        << "rounded in another way than here";
    EXPECT_THAT(findings("MAC470", "O1\nG65P9802A.31\n" + sum), SizeIs(1));
}

TEST(CallsWithNumbers, AreFollowedThroughCopies) {
    const std::string macro = "M30\nO9991\n#30=#7\nIF[#30GT5]GOTO99\nG0X#30\nM99\nN99#3000=101(D)\n";
    EXPECT_THAT(findings("MAC470", "O1\nG65P9991D7\n" + macro), SizeIs(1));
    EXPECT_THAT(findings("MAC470", "O1\nG65P9991D5\n" + macro), IsEmpty());
}

TEST(ArgumentsBesideIndices, AreReadWhereTheIndexMayReachThem) {
    const auto unread = [](const std::string& index) {
        return findings("MAC211",
                        "O1\n#100=20\nG65P9821A6.Z3.\nM30\nO9821\n#[500]=#1\nG0X#[" + index + "]\nM99\n");
    };
    EXPECT_THAT(unread("2400+#1"), SizeIs(1));
    EXPECT_THAT(unread("#1"), IsEmpty());
    EXPECT_THAT(unread("#100+#1"), IsEmpty()) << "the caller says 20";
}

TEST(JumpTables, TakeLabelsInARowForOneBranch) {
    const auto table = [](const std::string& branches) {
        return findings("MAC339", "O1\nIF[1EQ#1]GOTO10\nIF[#1EQ2]GOTO20\nIF[#1EQ3]GOTO30\nGOTO90\n" +
                                      branches + "N90M99\n");
    };
    EXPECT_THAT(table("N10#2=1\nGOTO90\nN20\nN30#2=3\nGOTO90\n"), IsEmpty());
    EXPECT_THAT(table("N10#2=1\nGOTO90\nN20#2=2\nN30#2=3\nGOTO90\n"), SizeIs(1));
    EXPECT_THAT(table("N10#2=1\nGOTO90\nN20#2=2\nN30#2=3\n"), SizeIs(1)) << "the last one runs into the end";
    EXPECT_THAT(table("N10#2=1\nM99\nN20#2=2\nN30#2=3\nM99\n"), SizeIs(1));
    EXPECT_THAT(table("N10#2=1\nN20#2=2\nN30#2=3\nGOTO90\n"), IsEmpty()) << "it is how the table works";
    EXPECT_THAT(table("N10#2=1\nGOTO90\nN20#2=2\nGOTO80\nN30#2=3\nGOTO90\nN80#2=8\n"), IsEmpty());
}

TEST(CoveredCases, AreToldOnlyWhereTheLaterOneIsSureToRun) {
    const auto cases = [](const std::string& between) {
        return findings("MAC214", "O1\nIF[#1GT100]THEN#101=50.\n" + between +
                                      "IF[#1GT50]THEN#101=80.\nG1X1.F#101\nM99\n");
    };
    EXPECT_THAT(cases(""), SizeIs(1));
    EXPECT_THAT(cases("#9=3\n"), SizeIs(1));
    EXPECT_THAT(cases("#1=#1-100\n"), IsEmpty());
    EXPECT_THAT(cases("#9=#101\n"), IsEmpty());
    EXPECT_THAT(cases("IF[#[100+#3]GT5]THEN#8=1.\n"), IsEmpty()) << "the index may mean #101";
    EXPECT_THAT(findings("MAC214", "O1\nIF[#1001EQ1]THEN#9=50.\nIF[#1001EQ1]THEN#9=80.\nG1X1.F#9\nM99\n"),
                IsEmpty())
        << "the input may have changed";
}

TEST(EarlyOutputs, AreThoseBehindTheMove) {
    const auto told =
        findings("MAC606", "O1\nWHILE[#1LT5]DO1\n#1101=0\nG91G0X10.\n#1101=1\n#1=#1+1\nEND1\nM99\n");
    ASSERT_THAT(told, SizeIs(1));
    EXPECT_THAT(told.front().message(), HasSubstr("#1101=1"));
    EXPECT_THAT(findings("MAC606", "O1\nG0X0\nM98P2\n#1101=1\nM99\n"), IsEmpty());
    EXPECT_THAT(findings("MAC606", "O1\nG103P1\nG0X0\n#1101=1\nM99\n"), IsEmpty());
}

TEST(Touches, AreCheckedByAWayToo) {
    const auto told = [](const std::string& check) {
        return findings("MAC607",
                        "O1\n#1=#5043\nG91G31Z-20.F50.\nG90\n" + check + "#5223=#5063\nM99\nN9#3000=1\n");
    };
    EXPECT_THAT(told(""), SizeIs(1));
    EXPECT_THAT(told("#2=#1-#5063\nIF[#2GT19.99]GOTO9\n"), IsEmpty());
    EXPECT_THAT(findings("MAC607", "O1\nIF[#1EQ1]GOTO5\nG91G31Z-20.F50.\nGOTO6\nN5G91G31Z-30.F50.\n"
                                   "N6#5223=#5063\nM99\n"),
                SizeIs(1))
        << "whichever it was, nothing asks";
    EXPECT_THAT(told("M78\n"), IsEmpty()) << "the function may raise an alarm";
    EXPECT_THAT(told("G65P9100\n"), IsEmpty()) << "so may a program";
}

TEST(ToolOfTheStart, MakesAHabitWhereItCuts) {
    const std::string rest = "T3M6\nG0X0Y0\nS900M3\nG1Z-3.F100.\nM30\n";
    const std::string head = "O1\nG90G54G17G21G0X100.Y80.\nG43H2Z50.S1000M3\n";
    EXPECT_THAT(findings("MAC568", head + "G1Z-3.F100.\nX0\n" + rest), SizeIs(1));
    EXPECT_THAT(findings("MAC568", head + rest), IsEmpty()) << "no tool has cut with an offset";
}

TEST(ValuesOfTheRunBefore, AreLeftByOneOfTwoWays) {
    const auto told = [](const std::string& other, const std::string& behind) {
        return findings("MAC216", "O1\nIF[#1EQ2]GOTO10\n#101=20\n#102=8\nGOTO20\nN10" + other +
                                      "\nN20G90G0X#101\n" + behind + "M99\n");
    };
    const auto one = told("#101=32", "Y#102\n");
    ASSERT_THAT(one, SizeIs(1));
    EXPECT_THAT(one.front().message(), HasSubstr("#102 is set on one way from"));
    EXPECT_THAT(told("#101=32\n#102=9", "Y#102\n"), IsEmpty());
    EXPECT_THAT(told("G0X0", "Y#102\n"), IsEmpty()) << "the ways have nothing in common";
    EXPECT_THAT(told("#101=32\nG65P9100", "Y#102\n"), IsEmpty()) << "the program may set it";
    EXPECT_THAT(told("#101=32", "IF[#1EQ2]GOTO30\nY#102\nN30\n"), IsEmpty()) << "read on its own way alone";
    EXPECT_THAT(findings("MAC216", "O1\nIF[#102EQ2]GOTO10\n#101=20\n#102=8\nGOTO20\nN10#101=32\n"
                                   "N20G90G0X#101\nY#102\nM99\n"),
                IsEmpty())
        << "the last value decides";
}

TEST(ValuesOfTheRunBefore, AreLeftByABranchOfATable) {
    const std::string table = "O1\nIF[#1EQ1]GOTO10\nIF[#1EQ2]GOTO20\n#3000=1(A)\nN10#101=1\n#102=1\nGOTO90\n"
                              "N20#101=2\n";
    EXPECT_THAT(findings("MAC216", table + "GOTO90\nN90G90G0X#101Y#102\nM99\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC216", table + "#102=2\nGOTO90\nN90G90G0X#101Y#102\nM99\n"), IsEmpty());
}

TEST(EarlyOutputs, AreNumbersThatSourcesCallSo) {
    EXPECT_THAT(findings("MAC606", "O1\nG0X0\n#1132=1\nM99\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC606", "O1\nG0X0\n#1136=1\nM99\n"), IsEmpty());
}

TEST(LimitsOfLookAhead, AreEndedOnEveryWayOrNone) {
    const auto told = [](const std::string& one, const std::string& other) {
        return run_rules(*test::analyse_text("fanuc", "O1\nG103P1\nIF[#3EQ1]GOTO2\n#1101=1\n" + one +
                                                          "M99\nN2#1101=0\n" + other + "M99\n"),
                         {{find_rule("MAC614")}}, 1);
    };
    const auto left = told("", "G103P0\n");
    ASSERT_THAT(left, SizeIs(1));
    EXPECT_THAT(left.front().message(),
                HasSubstr("'M99' returns under the limit of line 2, which line 7 ends"));
    EXPECT_THAT(told("G103\n", "G103P0\n"), IsEmpty());
    EXPECT_THAT(told("", ""), IsEmpty()) << "it may be meant for the caller";
    EXPECT_THAT(told("G65P9100\n", "G103P0\n"), IsEmpty()) << "the program may end it";
    EXPECT_THAT(told("G103P#1\n", "G103P0\n"), IsEmpty());
    EXPECT_THAT(
        findings("MAC614", "O1\nG103P0\nM98P2\nG103P1\nM0\nG103P0\nG0X1.\nG103P1\nM0\nM99\nO2\nM99\n"),
        IsEmpty())
        << "it begins anew without the limit";
    EXPECT_THAT(findings("MAC614", "O1\nG103P1\nIF[#3EQ1]GOTO2\nG103P0\nM98P3\nM99\nN2G103P0\nM99\n"
                                   "O3\nG103P1\nM99\n"),
                IsEmpty())
        << "it is the called program's";
    EXPECT_THAT(findings("MAC614", "O1\nG103P1\nIF[#3EQ1]GOTO2\n#1101=1\nM99\nN2#3000=1\nG103P0\n"),
                SizeIs(1))
        << "the end stands behind an alarm";
}

TEST(NumbersForValues, StandBehindTheSign) {
    const auto told = [](const std::string& rest) {
        return findings("MAC233", "O1\n#31=#18/4\nG91G1X-#[18-#31]F200.\n" + rest + "M99\n");
    };
    EXPECT_THAT(told(""), SizeIs(1));
    EXPECT_THAT(told("#[1+#2]=5.\n"), IsEmpty()) << "its variables are a list";
    EXPECT_THAT(findings("MAC233", "O1\nG91G1X-#[18-#31]F200.\nM99\n"), IsEmpty())
        << "nothing else reads #18";
}

} // namespace
} // namespace maclint
