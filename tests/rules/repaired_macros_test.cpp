//! Slips that stand in macros until somebody repairs them, each beside what is right.
#include "tests/rules/raised.hpp"
#include "tests/support/linted.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using test::lines_raised;
using test::messages_raised;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(PlaceForAnotherAxis, MovesOneThatItWasNotKeptFor) {
    const auto told = [](const std::string& kept, const std::string& move) {
        return messages_raised("MAC215", "O9814\n#10=#5041\n#11=" + kept + "\nG0X[#10+#7]\nG0Y[#11-#7]\nG0" +
                                             move + "\nM99\n");
    };
    EXPECT_THAT(told("#5041", "Y#11"), ElementsAre(HasSubstr("Take #5042")));
    EXPECT_THAT(told("#5042", "Y#11"), IsEmpty());
    EXPECT_THAT(told("#5041", "X#11"), IsEmpty()); // it is used for both
}

TEST(VariableOfAnotherStatement, IsGoneOnFromInOneOfSeveral) {
    const auto told = [](const std::string& blocks) {
        return lines_raised("MAC215", "O9100\n" + blocks + "M99\n");
    };
    EXPECT_THAT(told("#5222=#5222+#102\n#5242=#5242+#102\n#5262=#5242+#102\n"), ElementsAre(4));
    EXPECT_THAT(told("#5222=#5222+#102\n#5242=#5242+#102\n#5262=#5262+#102\n"), IsEmpty());
    EXPECT_THAT(told("#5222=#5222+#102\n#5262=#5242+#102\n"), IsEmpty());
    const std::string set_back = "IF[#510LT#520]GOTO9\n#510=0\n#511=0\nN9";
    EXPECT_THAT(told("M98P1\n#510=#510+1\nM98P2\n#511=#510+1\n" + set_back), ElementsAre(5));
    EXPECT_THAT(told("M98P1\n#510=#510+1\nM98P2\n#511=#511+1\n" + set_back), IsEmpty());
    EXPECT_THAT(told("M98P1\n#510=#510+1\nM98P2\n#511=#510+1\nX#511\n"), IsEmpty()); // the next number
    const std::string rows = "#10=5221+20*[#1-54]\n#11=5221+20*[#2-54]\n#[#11]=#[#10]+#24\n"
                             "#[#11+1]=#[#10+1]+#25\n";
    EXPECT_THAT(told(rows + "#[#11+2]=#[#10+1]+#26\n"), ElementsAre(6));
    EXPECT_THAT(told(rows + "#[#11+2]=#[#10+2]+#26\n"), IsEmpty());
}

TEST(NumberForAVariable, IsOneThatTheProgramSetsInVain) {
    const auto told = [](const std::string& blocks) {
        return lines_raised("MAC229", "O0050\n" + blocks + "M30\n");
    };
    EXPECT_THAT(told("#101=0\n#101=101+1\nX#101\n"), ElementsAre(3));
    EXPECT_THAT(told("#101=0\n#101=#101+1\nX#101\n"), IsEmpty());
    EXPECT_THAT(told("#549=#549+1\nG65P8500A549H4.\n"), IsEmpty()); // it counts itself
    EXPECT_THAT(told("#549=#500\nG65P8500A549H4.\n"), ElementsAre(3));
    EXPECT_THAT(told("#549=#500\nG65P8500A549H4.\nX#549\n"), IsEmpty());
    EXPECT_THAT(told("IF[#24EQ#0]GOTO9\nG0X[24*2.5]\nN9\n"), ElementsAre(3));
    EXPECT_THAT(told("IF[#24EQ#0]GOTO9\nG0X[#24*2.5]\nN9\n"), IsEmpty());
}

TEST(NumberForAValue, IsAddedUpWhereAnotherBlockPicksByIt) {
    const auto told = [](const std::string& second) {
        return lines_raised("MAC233", "O9700\n#10=5221+20*[#1-54]\n#11=5221+20*[#2-54]\n#[#11]=#[#10]+#24\n"
                                      "#[#11+1]=" +
                                          second + "\nM99\n");
    };
    EXPECT_THAT(told("#10+1+#25"), ElementsAre(5));
    EXPECT_THAT(told("#[#10+1]+#25"), IsEmpty());
    EXPECT_THAT(told("#10"), IsEmpty()); // a list of numbers
}

TEST(RatioAsLength, IsTheSameForTwoAxesOfACircle) {
    const auto told = [](const std::string& words) {
        return lines_raised("MAC230", "O9200(BOLTS, R CIRCLE A ANGLE)\nG0" + words + "\nM99\n");
    };
    EXPECT_THAT(told("X[#12+#18*COS[#1]]Y[#13+#18*COS[#1]]"), ElementsAre(2));
    EXPECT_THAT(told("X[#12+#18*COS[#1]]Y[#13+#18*SIN[#1]]"), IsEmpty());
    EXPECT_THAT(told("X[#12+#18*COS[#1]]Y[#13+#19*COS[#1]]"), IsEmpty()); // another circle
    EXPECT_THAT(told("X[#12+#18*COS[#1]]Y[#13+#18*COS[#2]]"), IsEmpty());
    EXPECT_THAT(told("X[#18*COS[#1]*SIN[#2]]Y[#18*COS[#1]*COS[#2]]"), IsEmpty()); // a sphere
}

TEST(LoopThatOnlyJumpsLeave, DoesNotChangeWhatItsConditionAsks) {
    const auto told = [](const std::string& counts, const std::string& behind) {
        return lines_raised("MAC319", "O9833\n#1=0\nWHILE[#1LT3]DO1\nG4P500\nIF[#1010EQ1]GOTO90\n" + counts +
                                          "END1\n" + behind + "N90M99\n");
    };
    EXPECT_THAT(told("", "#3000=33(PROBE)\n"), ElementsAre(3));
    EXPECT_THAT(told("#1=#1+1\n", "#3000=33(PROBE)\n"), IsEmpty());
}

TEST(BranchThatRunsOn, IsTheFirstOfTwinsThatLeave) {
    const auto told = [](const std::string& first_leaves, const std::string& second) {
        return lines_raised("MAC339",
                            "O10\nIF[#501EQ1]GOTO100\nIF[#501EQ2]GOTO200\n#3000=1(PALLET)\nN100M98P1001\n"
                            "#510=#510+1\n" +
                                first_leaves + "N200M98P2001\n" + second + "\nGOTO300\nN300M60\nM30\n");
    };
    EXPECT_THAT(told("", "#511=#511+1"), ElementsAre(5));
    EXPECT_THAT(told("GOTO300\n", "#511=#511+1"), IsEmpty());
    EXPECT_THAT(told("", "#511=#512*2"), IsEmpty()); // nothing alike
}

TEST(EqualBranches, DoTheSameWhateverNumbersTheyHave) {
    const auto told = [](const std::string& code) {
        return lines_raised("MAC337", "O9001\n#32=#4003\nG91G28Z0\nIF[#32EQ91]GOTO20\nG90\nGOTO30\nN20\n" +
                                          code + "\nN30\nM99\n");
    };
    EXPECT_THAT(told("G90"), ElementsAre(4));
    EXPECT_THAT(told("G91"), IsEmpty());
    const auto alarms = [](const std::string& second) {
        return lines_raised("MAC337",
                            "O9001\nIF[#3EQ1]GOTO5\n#3000=15(VISE)\nN5\n#3000=15(" + second + ")\n");
    };
    EXPECT_THAT(alarms("VISE"), ElementsAre(2));
    EXPECT_THAT(alarms("PRESSURE"), IsEmpty()); // the operator reads another text
    const auto stored = [](const std::string& first, const std::string& second) {
        return lines_raised("MAC337",
                            "O9001\nIF[#7EQ1]GOTO5\n" + first + "\nGOTO6\nN5\n" + second + "\nN6M99\n");
    };
    EXPECT_THAT(stored("#3=#5(LEFT)", "#3=#5(RIGHT)"), ElementsAre(2));
    EXPECT_THAT(stored("#3=4(A-AXIS)", "#3=4(B-AXIS)"), IsEmpty()); // numbers that somebody edits
}

TEST(ConditionAlwaysTrue, HoldsWhereACounterIsSetBackByItsOwnJump) {
    const auto told = [](const std::string& label) {
        return lines_raised(
            "MAC718", "O9858\nIF[#20NE#0]GOTO2\n#20=#4120\nN2\n#3=0\nN10\nG31Z-5.F1500\n#4=#5063\nG0Z50.\n"
                      "IF[ABS[#4]LT.5]GOTO50\n#3=#3+1\nIF[#3LT3]GOTO" +
                          label + "\n#3000=58(TOOL BROKEN)\nN50M99\n");
    };
    EXPECT_THAT(told("2"), ElementsAre(12));
    EXPECT_THAT(told("10"), IsEmpty());
}

TEST(ArgumentThatADefaultReplaces, MayBeReplacedByNought) {
    const auto told = [](const std::string& test) {
        return lines_raised("MAC211", "O9700\nIF[#24" + test + "#0]THEN#24=0\n#5221=#5221+#24\nM99\n");
    };
    EXPECT_THAT(told("NE"), ElementsAre(2));
    EXPECT_THAT(told("EQ"), IsEmpty());
}

TEST(OffsetOfAnotherTool, IsNoArgumentOfACall) {
    const auto told = [](const std::string& offset) {
        return lines_raised("MAC520", "O33\nT4M6\nG43H4Z25.\nG65P9200A0H8.T3.\nG0Z100.\nT6M6\nG43H" + offset +
                                          "Z25.\nG1Z-5.F100\nG0Z100.\nM30\n");
    };
    EXPECT_THAT(told("4"), ElementsAre(7));
    EXPECT_THAT(told("6"), IsEmpty());
}

TEST(OffsetOfAnotherTool, OfALatheStandsInTheLastFiguresOfT) {
    cli::Overrides overrides;
    overrides.control = "fanuc-16i-lathe";
    overrides.select = {"MAC520"};
    const std::string text = "O500\nG21G97S900M3\nT0101\nG0X40.Z2.\nG1Z-5.F.1\nG28U0W0\nT0301\nG0X40.Z2.\n"
                             "G1Z-5.\nG28U0W0\nT0505\nG0X30.Z2.\nG1Z-9.\nG28U0W0\nM30\n";
    const auto found = test::lint_texts({{"O500.nc", text}}, overrides).findings;
    ASSERT_THAT(found, SizeIs(1));
    EXPECT_THAT(found.front().finding.message(), HasSubstr("Write T0303"));
}

TEST(ValueLost, IsThatOfACaseThatRunsOnIntoTheNext) {
    const auto told = [](const std::string& leaves) {
        return lines_raised("MAC213", "O9601\nIF[#1LT#550]GOTO10\nIF[#2LT#550]GOTO20\n#3000=61(WORN)\n"
                                      "N10#551=#20\n" +
                                          leaves + "N20#551=#21\nN30T#551M6\nM99\n");
    };
    EXPECT_THAT(told(""), ElementsAre(5));
    EXPECT_THAT(told("GOTO30\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC213", "O9601\nN10#551=#500\nN20#551=#501\nN30T#551M6\nN40M99\n"), IsEmpty())
        << "#500 has it still";
}

TEST(NothingStored, IsASlipWhereEveryRunComesBy) {
    const auto told = [](const std::string& block) {
        return lines_raised("MAC213", "O500\nM98P501\n" + block + "\nIF[#530LT#531]GOTO9\n#530=0\nN9M99\n");
    };
    EXPECT_THAT(told("#530=#530"), ElementsAre(3));
    EXPECT_THAT(told("#530=#530+1"), IsEmpty());
    EXPECT_THAT(told("IF[#530EQ0]THEN#530=#530"), IsEmpty()); // a case in which nothing changes
}

TEST(OffsetOfATouch, IsPickedByANumberThatAVariableHolds) {
    const auto told = [](const std::string& asks) {
        return lines_raised("MAC607", "O9811\n#14=5223+20*[#19-54]\nG91G31Z-10.F100\n" + asks +
                                          "#[#14]=#5063\nG90\nM99\n");
    };
    EXPECT_THAT(told("").size(), 1U);
    EXPECT_THAT(told("IF[#5063LE#26]THEN#3000=1(NO TOUCH)\n"), IsEmpty());
}

TEST(MissingProgramEnd, IsToldOfAProgramThatOnlyDecides) {
    EXPECT_THAT(
        lines_raised("MAC455", "O9500(PARTS)\n#530=#530+1\nIF[#530LT#531]GOTO9\n#530=0\nN9#100=1\n").size(),
        1U);
    EXPECT_THAT(lines_raised("MAC455", "O9500(TABLE)\n#530=1\n#531=2\n"), IsEmpty()); // a list of data
}

} // namespace
} // namespace maclint
