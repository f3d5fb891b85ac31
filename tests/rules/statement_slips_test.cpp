//! Rules on slips in macro statements: numbers without their #, counters that another program uses, loops
//! that end only by equality, tolerances and angles.
#include "tests/rules/raised.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using test::judged;
using test::messages_raised;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(BareNumber, StandsInBracketsOrBesideWordsOfItsVariable) {
    EXPECT_THAT(
        messages_raised("MAC229", "O1\n#517=50.\nG65 P2 F[#517]\nG65 P2 F[517]\nM30\n"),
        ElementsAre(AllOf(HasSubstr("'[517]' is the number 517"), HasSubstr("line 3 has 'F[#517]'"))));
    EXPECT_THAT(messages_raised("MAC229", "O1\n#517=50.\n#518=[517]*2\nG0 X#518 Y#517\nM30\n"),
                ElementsAre(HasSubstr("other blocks say #517")));
    EXPECT_THAT(judged("MAC229", "O9001\nG0 X#24 Y#25\nX[24]\nM99\n"), ElementsAre("warning 3"));
    EXPECT_THAT(judged("MAC229", "O9001\nG0 X#24\nY[24]*2\nY[ATAN[#25]/[24]]\nM99\n"), IsEmpty())
        << "a small number in brackets may be meant";
    EXPECT_THAT(judged("MAC229", "O1\nG0 X[517]\nM30\n"), IsEmpty());
}

TEST(BareNumber, IsAWordWithoutAPointWhereTheOthersHaveOne) {
    const std::string pointed = "G0 X10. Y5.\nZ-2.\n";
    EXPECT_THAT(messages_raised("MAC229", "O9001\n" + pointed + "G1 X#18 F100.\nG1 X18 Y3.\nM99\n"),
                ElementsAre(AllOf(HasSubstr("'X18' is the number 18"), HasSubstr("line 4 has 'X#18'"))));
    EXPECT_THAT(judged("MAC229", "O9001\n" + pointed + "G1 X#18 F100.\nG1 X18. Y3.\nM99\n"), IsEmpty());
    EXPECT_THAT(judged("MAC229", "O9001\n" + pointed + "G1 X#18 F100.\nG1 X18 Y3\nM99\n"), IsEmpty())
        << "other numbers lack their point, too";
    EXPECT_THAT(judged("MAC229", "O9001\n" + pointed + "G1 Y#18 F100.\nG1 X18 Y3.\nM99\n"), IsEmpty());
}

TEST(Counter, IsOverwrittenByAProgramThatTheLoopCalls) {
    const auto row = [](const std::string& call, const std::string& counter, const std::string& called) {
        return "O1\n" + counter + "=0\nWHILE[" + counter + "LT5]DO1\n" + call + "\n" + counter + "=" +
               counter + "+1\nEND1\nM30\nO2\n" + called + "\nM99\n";
    };
    EXPECT_THAT(
        messages_raised("MAC217", row("G65 P2 X1.", "#100", "#100=#5041\nG0 X[#24+#100]")),
        ElementsAre(AllOf(HasSubstr("'G65 P2 X1.' runs O2, which uses #100"), HasSubstr("on line 3"))));
    EXPECT_THAT(judged("MAC217", row("M98 P2", "#1", "#1=#5041\nG0 X[#1+1.]")), ElementsAre("warning 4"));
    EXPECT_THAT(judged("MAC217", row("G65 P2 X1.", "#1", "#1=#5041\nG0 X[#24+#1]")), IsEmpty())
        << "G65 gives it a #1 of its own";
    EXPECT_THAT(judged("MAC217", row("G65 P2 X1.", "#100", "IF[#5041GT9.]THEN #100=99")), IsEmpty())
        << "it ends the loop of its caller";
    EXPECT_THAT(judged("MAC217", row("G65 P2 X1.", "#100", "#100=#100+1\nG0 X#100")), IsEmpty())
        << "it counts for its caller";
    EXPECT_THAT(judged("MAC217", row("G65 P2 X1.", "#100", "#101=#5041\nG0 X#101")), IsEmpty());
}

TEST(Loop, NeverRunsWhereItsCounterIsAsTheLoopBeforeLeftIt) {
    const std::string first = "O1\n#1=0\nWHILE[#1LT5]DO1\nG0 X#1\n#1=#1+1\nEND1\n";
    const std::string second = "WHILE[#1LT5]DO1\nG0 Y#1\n#1=#1+1\nEND1\nM30\n";
    EXPECT_THAT(messages_raised("MAC321", first + second),
                ElementsAre(HasSubstr("at '[#1LT5]', #1 is as the loop on line 3 has left it")));
    EXPECT_THAT(judged("MAC321", first + "#1=0\n" + second), IsEmpty());
    EXPECT_THAT(judged("MAC321", first + "IF[#500EQ1]THEN #1=0\n" + second), IsEmpty());
    EXPECT_THAT(judged("MAC321", "O1\n#1=9\n" + second), IsEmpty()) << "no loop left it so";
}

TEST(Loop, RunsOnceWhereNothingSetsItsCounterBack) {
    const auto rows = [](const std::string& before, const std::string& step, const std::string& behind) {
        return "O1\n#1=0\n#2=0\n#7=4\nWHILE[#1LT3]DO1\n" + before + "WHILE[#2LT#7]DO2\nG91 X1.\n" + step +
               "\nEND2\n" + behind + "#1=#1+1\nEND1\nM30\nO2\n#2=0\nM99\n";
    };
    const std::string step = "#2=#2+1";
    EXPECT_THAT(messages_raised("MAC321", rows("", step, "")),
                ElementsAre(AllOf(HasSubstr("only in the first round of the loop on line 5"),
                                  HasSubstr("at '[#2LT#7]', #2 is as this loop has left it"))));
    EXPECT_THAT(judged("MAC321", rows("#2=0\n", step, "")), IsEmpty());
    EXPECT_THAT(judged("MAC321", rows("", step, "#2=0\n")), IsEmpty());
    EXPECT_THAT(judged("MAC321", rows("IF[#1EQ1]THEN #2=0\n", step, "")), IsEmpty());
    EXPECT_THAT(judged("MAC321", rows("", step, "#7=#7+4\n")), IsEmpty()) << "its bound goes on";
    EXPECT_THAT(judged("MAC321", rows("M98 P2\n", step, "")), IsEmpty()) << "the subprogram sets it";
    EXPECT_THAT(judged("MAC321", rows("", step, "#[#1+1]=0\n")), IsEmpty());
    EXPECT_THAT(judged("MAC321", rows("", step + "\nIF[#5041GT9.]GOTO9", "N9")), IsEmpty())
        << "it may have ended before";
    EXPECT_THAT(judged("MAC321", "O1\nWHILE[#2LT4]DO2\nG91 X1.\n#2=#2+1\nEND2\nM99\n"), IsEmpty())
        << "the program may begin anew";
    EXPECT_THAT(judged("MAC321", "O1\n#1=0\n#2=0\nN5 G90 X0\nWHILE[#2LT4]DO2\nG91 X1.\n#2=#2+1\nEND2\n"
                                 "#1=#1+1\nIF[#1LT3]GOTO5\nM30\n"),
                ElementsAre("warning 5"));
}

TEST(Loop, ThatOnlyEqualityEndsIsPassedByItsCounter) {
    const auto loop = [](const std::string& start, const std::string& step, const std::string& bound) {
        return "O1\n#1=" + start + "\nWHILE[#1NE" + bound + "]DO1\nG91 X1.\n#1=#1" + step + "\nEND1\nM30\n";
    };
    EXPECT_THAT(
        messages_raised("MAC322", loop("0", "+2", "5")),
        ElementsAre(AllOf(HasSubstr("goes from 0 in steps of 2 and is never 5"), HasSubstr("'[#1NE5]'"))));
    EXPECT_THAT(judged("MAC322", loop("10", "-3", "0")), ElementsAre("warning 5"));
    EXPECT_THAT(judged("MAC322", loop("10", "+1", "5")), ElementsAre("warning 5"));
    EXPECT_THAT(judged("MAC322", loop("0", "+2", "6")), IsEmpty());
    EXPECT_THAT(judged("MAC322", loop("10", "-5", "0")), IsEmpty());
    EXPECT_THAT(judged("MAC322", "O1\n#1=0\nWHILE[#1LT5]DO1\nG91 X1.\n#1=#1+2\nEND1\nM30\n"), IsEmpty());
}

TEST(Loop, ThatOnlyEqualityEndsIsPassedWhereACallPassesAFraction) {
    const auto called = [](const std::string& bound) {
        return "O1\nG65 P9001 I" + bound +
               "\nM30\nO9001\nIF[#4EQ#0]THEN #3000=1(I)\n#1=0\nWHILE[#1NE#4]DO1\nG91 "
               "X1.\n#1=#1+1\nEND1\nM99\n";
    };
    EXPECT_THAT(messages_raised("MAC322", called("2.5")),
                ElementsAre(AllOf(HasSubstr("is never 2.5"), HasSubstr("which O1 line 2 passes"))));
    EXPECT_THAT(judged("MAC322", called("3.")), IsEmpty());
}

TEST(Tolerance, BelongsOutsideTheAmountOfADifference) {
    const auto test = [](const std::string& condition) {
        return "O9001\nIF[" + condition + "]GOTO9\nG0 X1.\nN9 M99\n";
    };
    EXPECT_THAT(messages_raised("MAC727", test("ABS[#5061-#24-.01]LT5.")),
                ElementsAre(HasSubstr("'ABS[#5061-#24-.01]' shifts the difference by .01")));
    EXPECT_THAT(judged("MAC727", test("#1GTABS[#5061-#24+.001]")), ElementsAre("warning 2"));
    for (const char* condition : {"ABS[#5061-#24]-.01LT5.", "ABS[#5061-#24-2.5]LT5.", "ABS[#5061-.01]LT5.",
                                  "ABS[#5061-#24-#18]LT5.", "ABS[#5061-#24-0]LT5."})
        EXPECT_THAT(judged("MAC727", test(condition)), IsEmpty()) << condition;
}

TEST(Angles, AreDegreesOnBothSidesOfTheFunctions) {
    const auto macro = [](const std::string& body) { return "O9001\n" + body + "\nM99\n"; };
    EXPECT_THAT(messages_raised("MAC707", macro("#3=SIN[#1*3.14159/180.]\nG0 X#3")),
                ElementsAre(HasSubstr("'[#1*3.14159/180.]' converts the angle")));
    EXPECT_THAT(judged("MAC707", macro("#30=#1/180*3.1416\nG0 X[COS[#30]]")), ElementsAre("warning 2"));
    EXPECT_THAT(judged("MAC707", macro("#29=ATAN[#4]/[#5]\n#29=#29*180/3.14\nG0 A#29")),
                ElementsAre("warning 3"));
    EXPECT_THAT(judged("MAC707", macro("#29=ACOS[#4]*180/3.14\nG0 A#29")), ElementsAre("warning 2"));
    EXPECT_THAT(judged("MAC707", macro("#30=#1*3.14159/180\nG0 X[#18*#30]")), IsEmpty())
        << "the length of an arc";
    EXPECT_THAT(judged("MAC707", macro("#30=#18*180/3.14159\nG0 X[SIN[#1]*#30]")), IsEmpty());
    EXPECT_THAT(judged("MAC707", macro("#29=ATAN[#4]/[#5]\n#30=#29*3.14159/180*#18\nG0 X#30")), IsEmpty());
    EXPECT_THAT(judged("MAC707", macro("#30=#1/#18*180/3.14159\nG0 X[SIN[#30]]")), IsEmpty())
        << "the angle of an arc of that length";
    EXPECT_THAT(judged("MAC707", macro("#30=SIN[#1*180/4]\nG0 X#30")), IsEmpty());
}

TEST(Angles, AreConvertedByOneFactorOrAVariableThatHoldsIt) {
    const auto macro = [](const std::string& body) { return "O9001\n" + body + "\nM99\n"; };
    EXPECT_THAT(judged("MAC707", macro("G0 X[COS[#1*.0174533]]")), ElementsAre("warning 2"));
    EXPECT_THAT(judged("MAC707", macro("G0 X[SIN[#1/57.2958]]")), ElementsAre("warning 2"));
    EXPECT_THAT(judged("MAC707", macro("#5=ATAN[#4]/[#6]*57.3\nG0 A#5")), ElementsAre("warning 2"));
    EXPECT_THAT(judged("MAC707", macro("#30=3.14159265\n#1=#1*#30/180\nG0 X[SIN[#1]]")),
                ElementsAre("warning 3"));
    EXPECT_THAT(judged("MAC707", macro("G0 X[COS[#1*57.2958]]")), IsEmpty());
    EXPECT_THAT(judged("MAC707", macro("G0 X[#1*.0174533]")), IsEmpty()); // the length of an arc
    EXPECT_THAT(judged("MAC707", macro("G0 X[COS[#1*.0175]]")), IsEmpty());
}

TEST(NumberForAVariable, IsThatOfTheWordsOwnArgument) {
    EXPECT_THAT(judged("MAC229", "O9001\nG0 X[24] Y#25\nG1 Y[#24+1.] F#9\nM99\n"), ElementsAre("warning 2"));
    EXPECT_THAT(judged("MAC229", "O9001\nG0 X[24] Y#25\nM99\n"), IsEmpty()); // nothing names #24
    EXPECT_THAT(judged("MAC229", "O9001\nG0 X[25] Y#25 Z#24\nM99\n"), IsEmpty());
    EXPECT_THAT(judged("MAC229", "O9001\nG0 X[24.] Y#25 Z#24\nM99\n"), IsEmpty());
}

TEST(ValueForANumber, PicksAVariableByWhatAnOffsetHolds) {
    EXPECT_THAT(judged("MAC233", "O9001\n#33=#[#2400+#7]\nG0 Z#33\nM99\n"), ElementsAre("warning 2"));
    EXPECT_THAT(judged("MAC233", "O9001\n#[#7+#5220]=#24\nM99\n"), ElementsAre("warning 2"));
    EXPECT_THAT(messages_raised("MAC233", "O9001\n#33=#[#2400+#7]\nG0 Z#33\nM99\n"),
                ElementsAre(HasSubstr("Write #2400 without its #")));
    EXPECT_THAT(judged("MAC233", "O9001\n#33=#[2400+#7]\nG0 Z#33\nM99\n"), IsEmpty());
    EXPECT_THAT(judged("MAC233", "O9001\n#33=#[#4120+#7]\nG0 Z#33\nM99\n"), IsEmpty()); // the tool in force
    EXPECT_THAT(judged("MAC233", "O9001\n#33=#[2000+#4111]\nG0 Z#33\nM99\n"), IsEmpty());
}

TEST(RatioAsLength, IsAFunctionOfAnAngleAlone) {
    const auto word = [](const std::string& words) {
        return judged("MAC230", "O9001\nG1 " + words + " F#9\nM99\n");
    };
    EXPECT_THAT(word("X-SIN[#1]"), ElementsAre("note 2"));
    EXPECT_THAT(word("X[COS[#1]] Y[-TAN[#1]]"), ElementsAre("note 2", "note 2"));
    EXPECT_THAT(word("X[#18*SIN[#1]]"), IsEmpty());
    EXPECT_THAT(word("A[ATAN[#4]/[#5]]"), IsEmpty()); // an axis that turns
    EXPECT_THAT(judged("MAC230", "O9001\nG65 P9002 X[SIN[#1]]\nM99\n"), IsEmpty());
}

} // namespace
} // namespace maclint
