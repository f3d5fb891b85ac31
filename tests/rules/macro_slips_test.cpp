//! Slips in macros that text shows, and what stands close to them and is right.
#include "tests/rules/raised.hpp"

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
using ::testing::Not;

TEST(ComparedWithItself, IsToldWhateverElseIsTested) {
    const auto told = [](const std::string& condition) {
        return lines_raised("MAC718",
                            "O9001\n#530=#530+1\nIF[" + condition + "]GOTO10\nM99\nN10#530=0\nM99\n");
    };
    EXPECT_THAT(told("#531GE#531"), ElementsAre(3));
    EXPECT_THAT(told("#531LT#531"), ElementsAre(3));
    EXPECT_THAT(told("#530GE#531"), IsEmpty());
    EXPECT_THAT(messages_raised("MAC718", "O9001\nIF[#1NE#1]THEN#3000=1(A)\nG0X#1\nM99\n"),
                ElementsAre(HasSubstr("compares a variable with itself")));
}

/// Rounds that begin at `N1#10=0`, are tested at N2 and counted.
std::vector<std::uint32_t> rounds(const std::string& back, const std::string& count = "#10=#10+1",
                                  const std::string& between = "") {
    return lines_raised("MAC319", "O9001\nN1#10=0\n" + between + "N2IF[#10GE#1]GOTO80\nG91G0X#2\n" + count +
                                      "\n" + back + "\nN80G90\nM99\n");
}

TEST(RoundsSetAgain, NeverEndOnceTheyComeBack) {
    EXPECT_THAT(rounds("GOTO1"), ElementsAre(6));
    EXPECT_THAT(rounds("GOTO2"), IsEmpty());
    EXPECT_THAT(rounds("GOTO1", "#1=#1-1"), IsEmpty()) << "its limit comes down";
    EXPECT_THAT(rounds("GOTO1", "#10=#10+1", "#10=#10+#500\n"), ElementsAre(7));
    EXPECT_THAT(rounds("GOTO1", "#500=#500+1", "#10=#10+#500\n"), IsEmpty());
    EXPECT_THAT(rounds("GOTO1", "IF[#5001GT100.]GOTO80"), IsEmpty()) << "a position ends it";
    EXPECT_THAT(rounds("GOTO1", "G65P9999"), IsEmpty()) << "nobody knows what O9999 does";
    EXPECT_THAT(rounds("GOTO1", "#10=#10+1", "IF[#5001GT100.]THEN#3000=1(END)\n"), IsEmpty())
        << "an alarm ends it";
    EXPECT_THAT(rounds("GOTO1", "#10=#10+1", "IF[#11EQ1]GOTO2\n#11=1\n"), ElementsAre(8));
    EXPECT_THAT(lines_raised("MAC319",
                             "O9001\nN1IF[#11EQ1]GOTO2\n#10=0\n#11=1\nN2IF[#10GE#1]GOTO80\nG91G0X#2\n"
                             "#10=#10+1\nGOTO1\nN80G90\nM99\n"),
                IsEmpty())
        << "only the first round sets it";
}

TEST(RoundsSetAgain, AreHeldAgainstTheFirstRound) {
    EXPECT_THAT(lines_raised("MAC319", "O9001\n#1=0\nWHILE[#1EQ0]DO1\nG91G0X5.\n#1=1\nEND1\nM99\n"),
                IsEmpty());
    EXPECT_THAT(
        lines_raised("MAC319", "O1\nN10#1=0\nM98P2\n#1=#1+1\nIF[#1LT#501]GOTO10\nM30\nO2\nG0X1.\nM99\n"),
        ElementsAre(5));
    EXPECT_THAT(
        lines_raised("MAC319", "O1\nN10#1=0\nM98P2\n#1=#1+1\nIF[#1LT#501]GOTO10\nM30\nO2\n#1=9\nM99\n"),
        IsEmpty())
        << "the program that it calls counts, too";
}

TEST(CountersNotSetBack, AreToldOfInnerLoops) {
    const auto told = [](const std::string& before, const std::string& inside) {
        return lines_raised("MAC321",
                            "O9001\n#31=0\n" + before + "WHILE[#31LT#1]DO1\n" + inside +
                                "WHILE[#32LT#2]DO2\nG0X#32\n#32=#32+1\nEND2\n#31=#31+1\nEND1\nM99\n");
    };
    EXPECT_THAT(told("#32=0\n", ""), ElementsAre(5));
    EXPECT_THAT(told("", "#32=0\n"), IsEmpty());
    EXPECT_THAT(told("#32=0\n", "#2=#2+1\n"), IsEmpty()) << "the limit moves on";
    EXPECT_THAT(told("#32=0\n", "G65P9999\n"), ElementsAre(6)) << "it has locals of its own";
    EXPECT_THAT(told("#32=0\n", "M98P9999\n"), IsEmpty());
    EXPECT_THAT(told("#32=0\n", "IF[#3EQ1]THEN#32=0\n"), IsEmpty());
}

TEST(PositionsOfOtherAxes, AreToldWhereTheRightOneIsRead) {
    const auto told = [](const std::string& blocks) {
        return lines_raised("MAC215", "O9001\n#1=#5042\nG91G31Y-15.F60.\nG90\nIF[#5062EQ#1]GOTO9\n" + blocks +
                                          "N9M99\n");
    };
    EXPECT_THAT(told("#5222=#5222+#5061-3.\n"), ElementsAre(6));
    EXPECT_THAT(told("#5222=#5222+#5062-3.\n"), IsEmpty());
    EXPECT_THAT(told("#5223=#5061\n"), IsEmpty()) << "nothing reads #5063";
    EXPECT_THAT(told("#101=#5061\n#5222=#5222+#101\n"), ElementsAre(7));
    EXPECT_THAT(told("#2=5222+20*[#19-54]\n#[#2]=#[#2]+#5061\n"), ElementsAre(7));
    EXPECT_THAT(told("#[5222+#2]=#5061\n"), IsEmpty()) << "#2 may be anything";
    EXPECT_THAT(told("#5222=#5221+#5061\n"), IsEmpty()) << "the offset of X is taken over";
    EXPECT_THAT(told("#5222=#5062+#5061\n"), IsEmpty());
    EXPECT_THAT(told("#5222=#5061-#5041\n"), IsEmpty()) << "a distance";
}

TEST(JumpsToAlarms, AreToldWhereTheEndIsLeftOut) {
    const auto told = [](const std::string& jump, const std::string& end) {
        return lines_raised("MAC302", "O9001\nIF[#1EQ#0]GOTO6\nG0X#1\n" + jump + "\n" + end +
                                          "N6#3000=61(A MISSING)\n");
    };
    EXPECT_THAT(told("GOTO6", "N60M99\n"), ElementsAre(4));
    EXPECT_THAT(told("GOTO60", "N60M99\n"), IsEmpty());
    EXPECT_THAT(told("GOTO6", "N61\n"), IsEmpty());
    EXPECT_THAT(told("IF[#1GT5]GOTO6\nM99", "N60M99\n"), IsEmpty()) << "it ends otherwise as well";
}

TEST(RunsIntoItsAlarm, AProgramThatChecksTheMachine) {
    const auto told = [](const std::string& condition, const std::string& end) {
        return lines_raised("MAC461", "O9001\nIF[" + condition + "]GOTO80\n#150=1\n" + end +
                                          "N80#3000=80(CLAMP OPEN)\n");
    };
    EXPECT_THAT(told("#1001EQ0", ""), ElementsAre(4));
    EXPECT_THAT(told("#1001EQ0", "M99\n"), IsEmpty());
    EXPECT_THAT(told("#1EQ2", ""), IsEmpty()) << "it may be there to show the text of a number";
}

TEST(NumbersThroughCalls, AreFollowedThroughThreeFurtherOnes) {
    const std::string inner = "O9415\n#10=#2/#1\nG1X#10F100.\nM99\n";
    const std::string wrapper = "O9414\nG65P9415A#24B#18\nM99\n";
    EXPECT_THAT(messages_raised("MAC702", "O1\nG65P9414X0.R5.\nM30\n" + wrapper + inner),
                ElementsAre(HasSubstr("for the call on line 2 of O1")));
    EXPECT_THAT(judged("MAC702", "O1\nG65P9414X2.R5.\nM30\n" + wrapper + inner), IsEmpty());
    EXPECT_THAT(judged("MAC702", "O1\nG65P9414R5.\nM30\n" + wrapper + inner), ElementsAre("note 8"))
        << "what is left out there is another question";
    const std::string maybe = "O9414\nIF[#24EQ0]GOTO9\nG65P9415A#24B#18\nN9M99\n";
    EXPECT_THAT(judged("MAC702", "O1\nG65P9414X0.R5.\nM30\n" + maybe + inner), ElementsAre("note 9"))
        << "the further call is not made for 0";
    const std::string chain = "O2\nG65P3A#1\nM99\nO3\nG65P4A#1\nM99\n";
    EXPECT_THAT(judged("MAC702", "O1\nG65P2A0\nM30\n" + chain + "O4\nG65P9415A#1B1.\nM99\n" + inner),
                ElementsAre("warning 14"));
    EXPECT_THAT(judged("MAC702",
                       "O1\nG65P2A0\nM30\n" + chain + "O4\nG65P5A#1\nM99\nO5\nG65P9415A#1B1.\nM99\n" + inner),
                ElementsAre("note 17"))
        << "too far away";
}

TEST(StepsOfCalls, AreToldByWhatIsPassed) {
    const std::string macro =
        "O9416\nIF[#26GE0]GOTO9\n#30=0\nN1#30=#30-#17\nG1Z#30F#9\nIF[#30GT#26]GOTO1\nM99\n"
        "N9#3000=9(Z)\n";
    const auto told = [&](const std::string& call) {
        return judged("MAC320", "O1\nG65P9416Z-12." + call + "F120.\nM30\n" + macro);
    };
    EXPECT_THAT(told("Q3."), ElementsAre("note 7"));
    EXPECT_THAT(told("Q0"), ElementsAre("warning 7"));
    EXPECT_THAT(told(""), ElementsAre("warning 7"));
    EXPECT_THAT(messages_raised("MAC320", "O1\nG65P9416Z-12.Q0F120.\nM30\n" + macro),
                ElementsAre(HasSubstr("for the call on line 2 of O1, which passes 0")));
}

TEST(StepsOfCalls, AreToldOfTheWrongSign) {
    const auto told = [](const std::string& step, const std::string& call) {
        return messages_raised("MAC320", "O1\nG65P9912Y40." + call + "\nM30\nO9912\n#30=#25\nN10G90G1Y#30\n" +
                                             step + "\nIF[#30GE-40.]GOTO10\nM99\n");
    };
    EXPECT_THAT(told("#30=#30+#17", "Q8."),
                ElementsAre(HasSubstr("leads away from the end of the loop for")));
    EXPECT_THAT(told("#30=#30-#17", "Q-8."), ElementsAre(HasSubstr("leads away")));
    EXPECT_THAT(told("#30=#30-ABS[#17]", "Q-8."), Not(ElementsAre(HasSubstr("leads away"))));
    EXPECT_THAT(told("#30=#30-#17", "Q8."), Not(ElementsAre(HasSubstr("leads away"))));
}

TEST(JumpsToTheNextBlock, DecideNothing) {
    const auto told = [](const std::string& blocks) {
        return messages_raised("MAC337", "O9001\nN10G4X.1\n" + blocks + "M99\n");
    };
    EXPECT_THAT(told("IF[#1001EQ0]GOTO20\nN20"), ElementsAre(HasSubstr("leads to the block behind it")));
    EXPECT_THAT(told("IF[#1001EQ0]GOTO10\nN20"), IsEmpty());
    EXPECT_THAT(told("IF[#1EQ1]GOTO10\nIF[#1EQ2]GOTO20\nN20"), IsEmpty()) << "the last case of a table";
    EXPECT_THAT(told("IF[#1GT50]GOTO10\nIF[#1001EQ0]GOTO20\nN20"), ElementsAre(HasSubstr("'[#1001EQ0]'")));
    EXPECT_THAT(told("IF[#1001EQ0]GOTO20\n(OWN STOP HERE)\nN20"), IsEmpty());
    EXPECT_THAT(told("IF[#1001EQ0]GOTO20\nG0X1.\nN20"), IsEmpty());
    EXPECT_THAT(told("IF[#1GT50]GOTO20\nG0X1.\nIF[#1001EQ0]GOTO20\nN20"), IsEmpty())
        << "others come there, too";
}

TEST(NumbersOfVariables, AreNotComparedForWhatTheyHold) {
    const auto told = [](const std::string& condition, const std::string& more = "") {
        return lines_raised("MAC233", "O9001\n#1=700+#20\n#2=800+#20\n" + more + "#[#1]=#[#1]+#[#2]\nIF[" +
                                          condition + "]GOTO8\n#3000=2(WORN)\nN8M99\n");
    };
    EXPECT_THAT(told("#1LT#2"), ElementsAre(5));
    EXPECT_THAT(told("#[#1]LT#[#2]"), IsEmpty());
    EXPECT_THAT(told("#1LT#20"), IsEmpty());
    EXPECT_THAT(told("#1LT#2", "#1=#1+1\n"), IsEmpty()) << "it is counted";
}

TEST(ArgumentsWithoutTheirPoint, AreToldOfMovesTheOtherWayRound) {
    const auto told = [](const std::string& word) {
        return lines_raised("MAC408", "O1\nG65P2X25.Z10\nM30\nO2\nG0X#24\n" + word + "F100.\nM99\n");
    };
    EXPECT_THAT(told("G1Z-#26"), ElementsAre(2));
    EXPECT_THAT(told("G1Z[#26*2]"), IsEmpty());
}

TEST(RemarksWithTools, AreHeldAgainstTheToolBeside) {
    const auto told = [](const std::string& lines) { return judged("MAC341", "O1\n" + lines + "M30\n"); };
    EXPECT_THAT(told("T21 M6 (T12 DRILL 8.5)\n"), ElementsAre("note 2"));
    EXPECT_THAT(told("(T12 DRILL 8.5)\nT21 M6\n"), ElementsAre("note 3"));
    EXPECT_THAT(told("T12 M6 (T12 DRILL 8.5)\n"), IsEmpty());
    EXPECT_THAT(told("(T1 DRILL)\n(T2 TAP)\nT1 M6\n"), IsEmpty()) << "a list";
    EXPECT_THAT(told("T0505 (T5 GROOVE)\n"), IsEmpty());
    EXPECT_THAT(told("T2 (AFTER T1)\n"), IsEmpty());
    EXPECT_THAT(told("T2 (T-SLOT)\n"), IsEmpty());
    EXPECT_THAT(told("G65 P9023 T5. (T6 IS NEXT)\n"), IsEmpty());
    EXPECT_THAT(told("T#20 M6 (T5)\n"), IsEmpty());
}

TEST(AnglesAsLengths, AreToldOfVariables) {
    const auto told = [](const std::string& blocks) {
        return judged("MAC230", "O9001\n" + blocks + "M99\n");
    };
    EXPECT_THAT(told("#3=ATAN[#4]/[#6]\nG1X#3F100.\n"), ElementsAre("note 3"));
    EXPECT_THAT(told("#3=SIN[#1]\nG1X-#3F100.\n"), ElementsAre("note 3"));
    EXPECT_THAT(told("#3=ATAN[#4]/[#6]\nG0A#3\n"), IsEmpty());
    EXPECT_THAT(told("#3=ATAN[#4]/[#6]\n#3=#6*TAN[#3]\nG1X#3F100.\n"), IsEmpty());
    EXPECT_THAT(told("G16\n#3=ATAN[#4]/[#6]\nG0X50.Y#3\nG15\n"), IsEmpty()) << "Y is an angle under G16";
    EXPECT_THAT(told("IF[#3EQ#0]THEN#3=ASIN[#4]\nG1X#3F100.\n"), IsEmpty());
}

TEST(HalvesOfPlaces, WantBrackets) {
    const auto told = [](const std::string& middle) {
        return judged("MAC230", "O9001\nG31X30.F60.\n#10=#5061\nG31X-30.\n#11=#5061\n#1=#5041\n#2=" + middle +
                                    "\nG0X#2\nM99\n");
    };
    EXPECT_THAT(told("#10+#11/2"), ElementsAre("note 7"));
    EXPECT_THAT(told("[#10+#11]/2"), IsEmpty());
    EXPECT_THAT(told("#10+#7/2"), IsEmpty()) << "half of a diameter";
    EXPECT_THAT(told("#10+#5062/2"), IsEmpty()) << "another axis";
    EXPECT_THAT(told("[#10+#10]/2"), ElementsAre("note 7"));
    EXPECT_THAT(told("[#10+#10]/3"), IsEmpty());
}

TEST(OffsetsUnderG91, AreAddedTo) {
    const auto told = [](const std::string& blocks) {
        return messages_raised("MAC524", "O9001\nG91G28Z0\n" + blocks + "M99\n");
    };
    EXPECT_THAT(told("G10L2P1X-300.Y-200.\nG90\n"), ElementsAre(HasSubstr("adds its numbers to the offset")));
    EXPECT_THAT(told("G10L2P1X#1\nG90\n"), ElementsAre(HasSubstr("adds its numbers")));
    EXPECT_THAT(told("G90G10L2P1X-300.\n"), IsEmpty());
    EXPECT_THAT(told("G91\nG10L2P1Z-.1\nG90\n"), IsEmpty()) << "G91 is given for it";
    EXPECT_THAT(told("G10L10P1R5.\nG90\n"), IsEmpty());
}

TEST(DefaultsOfArguments, StandWhereNothingWasPassed) {
    const auto told = [](const std::string& blocks) {
        return lines_raised("MAC211", "O9001\n" + blocks + "G1Z#26F#9\nM99\n");
    };
    EXPECT_THAT(told("IF[#9NE#0]THEN#9=100.\n"), ElementsAre(2));
    EXPECT_THAT(told("IF[#9EQ#0]GOTO5\n#9=100.\nN5\n"), ElementsAre(3));
    EXPECT_THAT(told("IF[#9EQ#0]THEN#9=100.\n"), IsEmpty());
    EXPECT_THAT(told("IF[#9NE#0]GOTO5\n#9=100.\nN5\n"), IsEmpty());
    EXPECT_THAT(told("IF[#9NE#0]THEN#9=#9*2\n"), IsEmpty());
    EXPECT_THAT(told("#1=#9\nIF[#9NE#0]THEN#9=100.\n"), IsEmpty()) << "what was passed is kept";
    EXPECT_THAT(lines_raised("MAC211", "O9001\nIF[#13NE#0]THEN#13=2\nIF[#13EQ2]GOTO9\nG0X#24\nN9M99\n"),
                IsEmpty())
        << "a mark";
}

TEST(MistakenNumbers, AreOneDigitApart) {
    const auto told = [](const std::string& blocks) {
        return judged("MAC213", "O9001\n" + blocks + "M99\n");
    };
    EXPECT_THAT(told("#112=#500/2\nG90G0X#122\n"), ElementsAre("note 2"));
    EXPECT_THAT(told("#102=#500/2\nG90G0X#120\n"), ElementsAre("note 2")) << "two digits exchanged";
    EXPECT_THAT(told("#112=#500/2\nG90G0X#139\n"), IsEmpty());
    EXPECT_THAT(told("#112=#500/2\nG90G0X#113\n"), IsEmpty()) << "a result, and what it is made of";
    EXPECT_THAT(told("G90G0X#122\n#112=#500/2\n"), IsEmpty());
    EXPECT_THAT(told("#112=#500/2\nG90G0X#122Y#112\n"), IsEmpty());
    EXPECT_THAT(told("#112=#500/2\n#113=#500/3\nG90G0X#122\n"), IsEmpty()) << "which of the two?";
    EXPECT_THAT(told("#112=#500/2\nM98P9999\nG90G0X#122\n"), IsEmpty());
    EXPECT_THAT(told("#512=#500/2\nG90G0X#522\n"), IsEmpty()) << "the operator sets these";
}

TEST(NumbersInCalculations, ThatAVariableHasWhichIsSetInVain) {
    const auto told = [](const std::string& blocks) {
        return lines_raised("MAC229", "O9001\n#517=50.\n" + blocks + "M99\n");
    };
    EXPECT_THAT(told("#30=517*2\nG1X#24F#30\n"), ElementsAre(3));
    EXPECT_THAT(told("#30=#517*2\nG1X#24F#30\n"), IsEmpty());
    EXPECT_THAT(told("#30=#[517+#1]\nG1X#24F#30\n"), IsEmpty());
    EXPECT_THAT(told("IF[#1EQ517]GOTO9\nG0X1.\nN9\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC229", "O9001\n#500=50.\n#30=500*2\nG1X#24F#30\nM99\n"), IsEmpty());
}

TEST(NumbersInSums, ThatTheLetterOfTheWordPasses) {
    const auto told = [](const std::string& words) {
        return lines_raised("MAC229", "O9001\nG0" + words + "\nG1Z#26F#9\nM99\n");
    };
    EXPECT_THAT(told("X[24+#1]Y[#25+#2]"), ElementsAre(2));
    EXPECT_THAT(told("X[24.+#1]Y[#25+#2]"), IsEmpty());
    EXPECT_THAT(told("X[24+#1]Y[25+#2]"), IsEmpty());
    EXPECT_THAT(told("X[30+#1]Y[#25+#2]"), IsEmpty());
}

TEST(OffsetsSetTwice, LoseTheFirst) {
    const auto told = [](const std::string& blocks) {
        return lines_raised("MAC213", "O9001\n" + blocks + "M99\n");
    };
    EXPECT_THAT(told("#5221=-400.+#1*120.\n#5221=-210.\n"), ElementsAre(2));
    EXPECT_THAT(told("#5221=-400.\n#5222=-210.\n"), IsEmpty());
    EXPECT_THAT(told("#5221=-400.\n#5221=#5221+#1\n"), IsEmpty());
    EXPECT_THAT(told("IF[#1EQ1]GOTO5\n#5221=-400.\nN5#5221=-210.\n"), IsEmpty());
    EXPECT_THAT(told("#1101=1\n#1101=0\n"), IsEmpty()) << "an output";
}

TEST(ModalCalls, AreMadeByLengthOffsets) {
    const auto told = [](const std::string& blocks) {
        return lines_raised("MAC415", "O1\nG66P9010Z-8.R2.\nX10.Y10.\n" + blocks + "G67\nM30\n");
    };
    EXPECT_THAT(told("G43H21Z20.\nX40.\n"), ElementsAre(4));
    EXPECT_THAT(told("G43H21\nX40.\n"), IsEmpty()) << "no move";
    EXPECT_THAT(told("X40.\nG67\nG43H21Z20.\n"), IsEmpty());
}

TEST(PlacesOfTouches, AreNotComparedExactly) {
    const auto told = [](const std::string& condition) {
        return lines_raised("MAC710", "O9001\n#1=#5043-20.\nG91G31Z-20.F80.\nG90\nIF[" + condition +
                                          "]THEN#3000=5(NO CONTACT)\nM99\n");
    };
    EXPECT_THAT(told("#5063EQ#1"), ElementsAre(5));
    EXPECT_THAT(told("#5063LE#1"), IsEmpty());
    EXPECT_THAT(told("#5063EQ#5043"), IsEmpty()) << "both are read";
    EXPECT_THAT(told("#5063EQ#26"), IsEmpty());
}

TEST(LimitsPassedOver, AreStillOn) {
    const auto told = [](const std::string& end) {
        return lines_raised("MAC614", "O9614\nG103P1\nIF[#3EQ1]GOTO9\n#1101=1\n" + end + "M99\n");
    };
    EXPECT_THAT(told("G103P0\nN9"), ElementsAre(6));
    EXPECT_THAT(told("N9G103P0\n"), IsEmpty());
    EXPECT_THAT(told("G103P0\nG65P9100\nN9G4P1\nG65P9100\n"), IsEmpty()) << "the call may end it";
    EXPECT_THAT(lines_raised("MAC614", "O9614\nIF[#3EQ1]GOTO8\nG103P1\nN8#1101=1\nIF[#3EQ1]GOTO9\nG103P0\n"
                                       "N9M99\n"),
                IsEmpty())
        << "the way around the end is the way around the limit";
}

TEST(NumbersOfCodes, HaveFourDigitsAtMost) {
    EXPECT_THAT(lines_raised("MAC107", "O1\nG659811X10.\nM30\n"), ElementsAre(2));
    EXPECT_THAT(lines_raised("MAC107", "O1\nG0310X10.\nM30\n"), IsEmpty());
}

} // namespace
} // namespace maclint
