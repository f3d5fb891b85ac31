//! Slips in the cases and the moves of programs, each beside what is right.
#include "tests/rules/raised.hpp"
#include "tests/support/linted.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using test::judged;
using test::lines_raised;
using test::messages_raised;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(BranchThatRunsOn, HasATwinThatDoesNot) {
    const auto told = [](const std::string& first, const std::string& second) {
        return lines_raised("MAC339", "O7232\nIF[#140EQ1]GOTO10\nIF[#140EQ2]GOTO20\nGOTO90\nN10(LEFT)\n" +
                                          first + "N20(RIGHT)\n" + second +
                                          "GOTO99\nN90#3000=40(PALLET)\nN99M99\n");
    };
    const std::string left = "G1X6.F300.\nY6.\nG0Z2.\n", right = "G1X8.F200.\nY9.\nG0Z5.\n";
    EXPECT_THAT(told(left, right), ElementsAre(5));
    EXPECT_THAT(told(left + "GOTO99\n", right), IsEmpty());
    EXPECT_THAT(told("G1X6.F300.\n", right), IsEmpty()); // another thing, perhaps one more
}

TEST(BranchThatRunsOn, IsOneThatANumberJumpsTo) {
    const auto told = [](const std::string& end_of_second) {
        return lines_raised("MAC339",
                            "O9231\nIF[#1LT1]GOTO800\nIF[#1GT3]GOTO800\nGOTO[FIX[#1]*100]\nN100G1X#7F#9\n"
                            "GOTO900\nN200G1Y#7F#9\n" +
                                end_of_second + "N300G1Z#7F#9\nN900M99\nN800#3000=31(A)\n");
    };
    EXPECT_THAT(told(""), ElementsAre(7));
    EXPECT_THAT(told("GOTO900\n"), IsEmpty());
}

TEST(EndInTheMiddle, IsOneThatReturns) {
    const auto told = [](const std::string& between) {
        return lines_raised("MAC460", "O8412(TWO ROWS)\nG81X0Y0Z-6.R2.F150.\nX15.\nG80\n" + between +
                                          "Y20.\nX0\nG80\nM99\n");
    };
    EXPECT_THAT(told("M99\n"), ElementsAre(6));
    EXPECT_THAT(told(""), IsEmpty());
    EXPECT_THAT(told("M99\n(THE SECOND ROW)\n"), IsEmpty()); // a part of its own
}

TEST(EndInTheMiddle, StandsInFrontOfAJumpBack) {
    const auto told = [](const std::string& end) {
        return lines_raised("MAC460", "O0414\n#100=0\nN2G0X[#100*50.]\n#100=#100+1\n" + end +
                                          "IF[#100LT3]GOTO2\nG0X200.\nM30\n");
    };
    EXPECT_THAT(told("M30\n"), ElementsAre(7));
    EXPECT_THAT(told(""), IsEmpty());
}

TEST(OnlyEnd, IsOneThatNoJumpLeadsTo) {
    const auto told = [](const std::string& target) {
        return lines_raised("MAC460", "O9314\nN100#20=0\nM55\nWHILE[#20LT10]DO1\nIF[#1015EQ1]GOTO" + target +
                                          "\n#20=#20+1\nEND1\n#3000=14(COOLANT LOW)\nN200M56\nM99\n");
    };
    EXPECT_THAT(told("100"), ElementsAre(9));
    EXPECT_THAT(told("200"), IsEmpty());
}

TEST(CommonOfALetter, IsReadWhereTheLetterIsLeftOut) {
    const auto told = [](const std::string& before, const std::string& condition, const std::string& behind) {
        return lines_raised("MAC216", "O9238\n" + before + condition + "\n#101=#11*2\nN10G90G0X[#24+#101]\n" +
                                          behind + "M99\nN19#3000=1(H)\n");
    };
    EXPECT_THAT(told("", "IF[#11EQ#0]GOTO10", ""), ElementsAre(4));
    EXPECT_THAT(told("#101=0\n", "IF[#11EQ#0]GOTO10", ""), IsEmpty());
    EXPECT_THAT(told("", "IF[#11EQ#0]GOTO10", "#101=0\n"), IsEmpty()) << "it is put back for the next run";
    EXPECT_THAT(told("", "IF[#11EQ#0]GOTO19", ""), IsEmpty());
    EXPECT_THAT(told("IF[#1EQ2]GOTO10\n", "IF[#11EQ#0]GOTO19", ""), IsEmpty()) << "another condition does it";
    EXPECT_THAT(told("", "IF[#1EQ#0]GOTO10", ""), IsEmpty()) << "it is calculated from another letter";
}

TEST(CodeOfAnotherGroup, IsLookedForInVain) {
    const auto told = [](const std::string& condition) {
        return messages_raised("MAC234", "O9236\nIF[" + condition + "]GOTO9\nG0Z#26\nM99\nN9#3000=1(NO)\n");
    };
    EXPECT_THAT(told("#4008NE40"), ElementsAre(AllOf(HasSubstr("always true"), HasSubstr("Read #4007"))));
    EXPECT_THAT(told("90EQ#4006"), ElementsAre(AllOf(HasSubstr("never true"), HasSubstr("Read #4003"))));
    for (const std::string condition : {"#4007NE40", "#4008EQ49", "#4005EQ98", "#4001EQ80", "#4012EQ54",
                                        "#4014EQ54.1", "#4008EQ#1", "#4008GT40", "#4008EQ400"})
        EXPECT_THAT(told(condition), IsEmpty()) << condition;
}

TEST(NumberInBrackets, OfACalculationIsThatOfAnArgument) {
    const auto told = [](const std::string& value) {
        return lines_raised("MAC229",
                            "O9237\nIF[#6LE0]GOTO9\n#4=0\n#5=" + value + "\nG0Z#5\nM99\nN9#3000=1(K)\n");
    };
    EXPECT_THAT(told("[#4+1]*[6]"), ElementsAre(4));
    EXPECT_THAT(told("[#4+1]*[#6]"), IsEmpty());
    EXPECT_THAT(told("[#4+1]*6"), IsEmpty());
    EXPECT_THAT(told("[#4+1]*[7]"), IsEmpty()) << "nothing else names #7";
    EXPECT_THAT(told("[#6]*[6]"), IsEmpty()) << "brackets are a habit";
}

TEST(PlaceOfOneAxis, StandsForTwoWhereTheOtherIsReadNowhere) {
    const auto told = [](const std::string& second, const std::string& last) {
        return lines_raised("MAC215", "O9217\n#10=#5221-#501\n" + second +
                                          "\n#5241=#501+#10*COS[#1]-#11*SIN[#1]\n"
                                          "#5242=#502+#10*SIN[#1]+#11*COS[#1]\n" +
                                          last + "\nG55\nM99\n");
    };
    EXPECT_THAT(told("#11=#5221-#502", "#5243=#5223"), ElementsAre(3));
    EXPECT_THAT(told("#11=#5222-#502", "#5243=#5223"), IsEmpty());
    EXPECT_THAT(told("#11=#5221-#502", "#503=#5222"), IsEmpty()) << "it knows the place of Y";
    EXPECT_THAT(told("#11=#5221-#501", "#5243=#5223"), IsEmpty()) << "nothing goes on to the next";
    EXPECT_THAT(lines_raised("MAC215", "O9239\n#10=#5221-#501+#520\n#11=#5221-#502+#540\n"
                                       "#5241=#501+#10\n#5242=#502+#11\n#5243=#5223\nG55\nM99\n"),
                IsEmpty())
        << "two numbers of one axis";
}

TEST(LateLift, MovesAsideBeforeIt) {
    const auto told = [](const std::string& between) {
        return lines_raised("MAC555", "O0511\nG21G17G90G54G0X0Y0\nG43H3Z2.\nG1Z-6.F120.\nX50.F300.\n" +
                                          between + "M30\n");
    };
    EXPECT_THAT(told("G0X0Y40.\nZ2.\nG1Z-6.F120.\nX50.F300.\nG0Z50.\n"), ElementsAre(6));
    EXPECT_THAT(told("G0Z2.\nX0Y40.\nG1Z-6.F120.\nX50.F300.\nG0Z50.\n"), IsEmpty());
    EXPECT_THAT(told("G0X90.\nZ50.\n"), IsEmpty());          // it leaves the part at its side
    EXPECT_THAT(told("G0X90.Y40.\nZ50.\n"), ElementsAre(6)); // across the part
    EXPECT_THAT(told("G0X0Y0\nZ50.\n"), IsEmpty());          // where it came down
    EXPECT_THAT(told("G0X90.Y40.Z50.\n"), IsEmpty());
    EXPECT_THAT(told("G0G40X90.Y40.\nZ50.\n"), IsEmpty()); // it leaves an outline
    EXPECT_THAT(told("G1G41D3Y40.\nX20.\nG40Y50.\nG0X90.Y40.\nZ50.\n"), IsEmpty());
    EXPECT_THAT(told("G1Y40.\nG0X90.Y40.\nX0Y0\nZ50.\n"), IsEmpty());
    EXPECT_THAT(told("G91G28X0Y0\nG28Z0\n"), ElementsAre(6));
    EXPECT_THAT(told("G91G28Z0\nG28X0Y0\n"), IsEmpty());
    const std::string called = "O8513\nG90G0Z1.\nG1Z-5.F90.\nG91X4.F250.\nX-4.\nG90\n";
    const std::string calls =
        "O0513\nG90G54G0X15.Y15.\nG43H8Z20.\nM98P8513\nG0X65.Y15.\nM98P8513\nG0Z60.\nM30\n";
    EXPECT_THAT(lines_raised("MAC555", calls + called + "M99\n"), ElementsAre(5));
    EXPECT_THAT(lines_raised("MAC555", calls + called + "G0Z20.\nM99\n"), IsEmpty());
}

TEST(ArcWithLettersOfAnotherPlane, SaysZero) {
    const auto told = [](const std::string& plane, const std::string& arc) {
        return lines_raised("MAC522",
                            "O0351\nG90G17G21G0X-10.Y0\nG1Z0F500.\n" + plane + "\n" + arc + "\nM30\n");
    };
    EXPECT_THAT(told("G18", "G3X0Z0I5.J0"), IsEmpty()); // it changes nothing
    EXPECT_THAT(told("G18", "G3X0Z0I5.K0"), IsEmpty());
    EXPECT_THAT(told("G18", "G3X0Y0I5.J0"), ElementsAre(5));
    EXPECT_THAT(told("G17", "G3X0Y0I5.J0"), IsEmpty());
    EXPECT_THAT(told("G19", "G3X0Z0I#1K0"), ElementsAre(5)) << "whatever #1 is";
    EXPECT_THAT(told("G19", "G3X0Z0I#1K#2"), IsEmpty()) << "a pitch beside a centre";
    const std::string lathe = "O0352\nG28U0W0\nT0404\nG50S3000\nG96S150M3\nG0X0Z0\nG3X10.Z-5.I0";
    EXPECT_THAT(lines_raised("MAC522", lathe + "J-5.F.1\nM30\n"), ElementsAre(7));
    EXPECT_THAT(lines_raised("MAC522", lathe + "K-5.F.1\nM30\n"), IsEmpty());
}

TEST(ArcOfACall, LiesInThePlaneOfItsCaller) {
    const auto told = [](const std::string& plane, const std::string& arc) {
        return messages_raised(
            "MAC522",
            "O0200\n" + plane +
                "G21G90G54G0X0Y0\nG65P9130X30.Y30.I15.D10.F900.\nM30\n"
                "O9130\nIF[#7LE0]THEN#3000=1(D)\n#31=#4-#7/2\n#1=0\nWHILE[#1LT2]DO1\nG90G0X#24Y#25\n"
                "G1X[#24+#31]F#9\n" +
                arc + "\n#1=#1+1\nEND1\nM99\n");
    };
    EXPECT_THAT(told("G17", "G3K-#31"), ElementsAre(HasSubstr("under G17")));
    EXPECT_THAT(told("G18", "G3K-#31"), IsEmpty());
    EXPECT_THAT(told("", "G3K-#31"), IsEmpty());
    EXPECT_THAT(told("G17", "G3I-#31"), IsEmpty());
}

TEST(RowOfAnotherCase, SetsOneVariableOfTheFirst) {
    const auto told = [](const std::string& last) {
        return lines_raised("MAC215", "O9252\nIF[#160EQ1]GOTO1\nIF[#160EQ2]GOTO2\n#3000=52(PALLET)\n"
                                      "N1#7001=#7001+#24\n#7002=#7002+#25\n#7003=#7003+#26\nGOTO9\n"
                                      "N2#7021=#7021+#24\n#7022=#7022+#25\n" +
                                          last + "\nN9M99\n");
    };
    EXPECT_THAT(told("#7003=#7003+#26"), ElementsAre(11));
    EXPECT_THAT(told("#7023=#7023+#26"), IsEmpty());
    EXPECT_THAT(told("#510=#510+1"), IsEmpty());
    const std::string counter = "O9254\nIF[#160EQ1]GOTO1\nIF[#160EQ2]GOTO2\n#3000=52(PALLET)\n"
                                "N1#501=#501+#24\n#502=#502+#25\n#509=#509+1\nGOTO9\n"
                                "N2#511=#511+#24\n#512=#512+#25\n#509=#509+1\nN9M99\n";
    EXPECT_THAT(lines_raised("MAC215", counter), IsEmpty()); // of both
    const auto guarded = [](const std::string& last) {
        return lines_raised("MAC215", "O9253\n#30=FIX[#4120/100]\nIF[#30EQ2]THEN#2002=#2002-#21\n"
                                      "IF[#30EQ2]THEN#2102=#2102-#23\nIF[#30EQ4]THEN#2004=#2004-#21\n"
                                      "IF[#30EQ4]THEN" +
                                          last + "\nM99\n");
    };
    EXPECT_THAT(guarded("#2102=#2102-#23"), ElementsAre(6));
    EXPECT_THAT(guarded("#2104=#2104-#23"), IsEmpty());
}

TEST(StepOfKnownSign, LeadsAwayFromTheEnd) {
    const auto told = [](const std::string& step, const std::string& checks, const std::string& clamp) {
        return lines_raised("MAC320", "O9130\nIF[#17" + checks +
                                          "0]GOTO9\nIF[#26GE#18]GOTO9\n#32=#18\n"
                                          "WHILE[#32GT#26]DO1\n#32=#32" +
                                          step + "#17\n" + clamp + "G1Z#32F#9\nEND1\nM99\nN9#3000=32(Q)\n");
    };
    EXPECT_THAT(told("+", "LE", ""), ElementsAre(6));
    EXPECT_THAT(told("-", "LE", ""), IsEmpty());
    EXPECT_THAT(told("-", "GE", ""), ElementsAre(6));
    const std::string clamp = "IF[#32GE#26]GOTO1\n#32=#26\nN1";
    EXPECT_THAT(told("+", "LE", clamp), ElementsAre(6));
    EXPECT_THAT(told("-", "LE", clamp), IsEmpty());
    EXPECT_THAT(told("+", "LE", "IF[#32LE50.]GOTO1\n#32=#26\nN1"), IsEmpty()); // it ends at 50
}

TEST(SpecialCaseLost, IsNotOneThatANumberOfTheTextDecides) {
    const auto told = [](const std::string& first, const std::string& second) {
        return lines_raised("MAC214", "O0213\n#1=70.\n#10=1200\nIF[#1GT" + first + "]THEN#10=800\nIF[#1GT" +
                                          second + "]THEN#10=500\nG97S#10M3\nG0X#1\nM30\n");
    };
    EXPECT_THAT(told("60.", "30."), ElementsAre(4));
    EXPECT_THAT(told("30.", "60."), IsEmpty());
}

TEST(WhileWithAJump, LacksItsDo) {
    const std::string text = "O0311\n#1=5\nWHILE[#1GT2]GOTO3\n#1=#1-1\nEND3\nM30\n";
    EXPECT_THAT(messages_raised("MAC311", text), ElementsAre(HasSubstr("DO3 in place of 'GOTO3'")));
    for (const char* code : {"MAC301", "MAC332", "MAC313"})
        EXPECT_THAT(lines_raised(code, text), IsEmpty()) << code;
}

TEST(AddressTwice, IsOneNumber) {
    EXPECT_THAT(messages_raised("MAC559", "O1\nG1X5.F0.010F.010\nM30\n"),
                ElementsAre(HasSubstr("both times")));
    EXPECT_THAT(messages_raised("MAC559", "O1\nG1X5.F0.010F.1\nM30\n"), ElementsAre(HasSubstr("F0.010")));
}

TEST(TestTwice, IsACopy) {
    const std::string text = "O1\nIF[#853GT24.75]THEN#605=30.\nIF[#853GT24.75]THEN#605=3";
    EXPECT_THAT(judged("MAC719", text + "0.\nG0X#605\nM30\n"), ElementsAre("note 3"));
    const std::string wide =
        "O1\nIF[#853GT24.75]THEN#605=30.\nIF[#853GT24.75]THEN #605 = 30.\nG0X#605\nM30\n";
    EXPECT_THAT(judged("MAC719", wide), ElementsAre("note 3"));
    EXPECT_THAT(judged("MAC719", text + "5.\nG0X#605\nM30\n"), ElementsAre("warning 3"));
}

TEST(MoveOfNoLength, CutsNothing) {
    const std::string head = "O8610\nN1G18G40G99\nT0101\nG97S500M4\nG1",
                      tail = "\nG0X50.Z2.\nG1Z-5.F.2\nM30\n";
    EXPECT_THAT(lines_raised("MAC553", head + "U0.W0." + tail), IsEmpty());
    EXPECT_THAT(lines_raised("MAC553", head + "U1.W0." + tail), ElementsAre(5));
}

TEST(ModeThatACallPutsBack, IsAsBefore) {
    const auto told = [](const std::string& end) {
        return lines_raised("MAC567", "O0900\nG21G17G90G54\nT1M6\nG0X0Y0S900M3\nG43H1Z50.\nG1Z-5.F200.\n"
                                      "G65P9001\nG0Z50.\nG28Z0\nM30\nO9001\n#1=#4003\nG91G0Z1.\n" +
                                          end + "M99\n");
    };
    EXPECT_THAT(told("G#1\n"), ElementsAre(9));
    EXPECT_THAT(told(""), IsEmpty()); // G91 is left on
}

TEST(ToolOfACall, IsTheOneThatItPasses) {
    const std::string macro = "O9001\n#32=#4003\nM5\nG91G28Z0\nG90\nT#20M6\nG#32\nM99\n";
    const auto told = [&](const std::string& offset) {
        return lines_raised("MAC520",
                            "O0900\nG17G21G90\nG65P9001T1\nG54G0X0Y0S5000M3\nG43H1Z50.\nG1Z-1.F400.\n"
                            "G65P9001T2\nG54G0X9.Y0S5000M3\nG43H2Z50.\nG1Z-1.F400.\nG65P9001T3\n"
                            "G54G0X8.Y0S5000M3\nG43H" +
                                offset + "Z50.\nG1Z-1.F400.\nG0Z50.\nM30\n" + macro);
    };
    EXPECT_THAT(told("2"), ElementsAre(13));
    EXPECT_THAT(told("3"), IsEmpty());
}

} // namespace
} // namespace maclint
