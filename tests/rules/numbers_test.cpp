//! Rules about numbers: MAC702, MAC703, MAC704, MAC710, MAC718.
#include "tests/rules/raised.hpp"

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

TEST(ConstantCondition, IsNotNeededWhereAnotherDoesTheSameHoweverItIsWritten) {
    const auto pair = [](const std::string& second) {
        return "O9001\nIF[#6LT54]GOTO8\nIF[#6LT54]THEN#31=-1\nIF[#6LT55]THEN" + second + "\nX#31\nN8 M99\n";
    };
    EXPECT_THAT(lines_raised("MAC718", pair("#31=-1")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC718", pair(" # 31 = - 1")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC718", pair("#31=-2")), ElementsAre(3));
}

TEST(DivisionByZero, OfALiteralOrAStoredZeroIsReported) {
    EXPECT_THAT(lines_raised("MAC702", "O9001\n#5=#2/0\nX[5/0.0]\nM99\n"), ElementsAre(2, 3));
    EXPECT_THAT(lines_raised("MAC702", "O9001\n#1=0\n#5=#2/#1\nM99\n"), ElementsAre(3));
    EXPECT_THAT(path_raised("MAC702", "O9001\n#1=0\nIF[#2GT5]GOTO1\nM99\nN1 #5=#2/#1\nM99\n"),
                ElementsAre(2, 3, 5));
    EXPECT_THAT(lines_raised("MAC702", "O9001\nIF[#1NE0]GOTO1\n#5=1\nN1 #5=#2/[#1-#1]\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC702", "O9001\nIF[#1NE0]GOTO1\n#5=#2/#1\nN1 M99\n"), ElementsAre(3));
}

TEST(DivisionByZero, ThatOneOfTwoPathsEscapesIsNotCertain) {
    EXPECT_THAT(lines_raised("MAC702", "O9001\n#1=0\nIF[#2EQ1]THEN#1=3\n#5=#2/#1\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC702", "O9001\n#1=0\nIF[#1EQ0]GOTO9\n#5=#2/#1\nN9 M99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC702", "O9001\n#6=#2/#3003\nM99\n"), IsEmpty());
    // 0 or never set: that is said of the variable.
    EXPECT_THAT(lines_raised("MAC702", "O9001\nIF[#2GT5]GOTO1\n#30=0\nN1 #5=#2/#30\nM99\n"), IsEmpty());
}

TEST(DivisionByZero, ByAnArgumentThatNothingChecksIsANote) {
    EXPECT_THAT(judged("MAC702", "O9001\n#5=#2/#1\nM99\n"), ElementsAre("note 2"));
    EXPECT_THAT(judged("MAC702", "O9001\n#5=#2/[2*ABS[#1]]\nM99\n"), ElementsAre("note 2"));
    EXPECT_THAT(judged("MAC702", "O9001\n#5=#2/#1\n#6=#3/#1\nM99\n"), ElementsAre("note 2"));
    EXPECT_THAT(judged("MAC702", "O9001\n#5=#2/[#1-#3]\nM99\n"), IsEmpty()); // nobody means these to differ
    EXPECT_THAT(judged("MAC702", "O9001\n#5=#2/[#1*#1+1]\nM99\n"), IsEmpty());
}

TEST(DivisionByZero, ByAVariableOfAllProgramsIsANoteUnlessSomebodySetsItOrItIsKept) {
    EXPECT_THAT(judged("MAC702", "O9001\n#5=#2/#101\nM99\n"), ElementsAre("note 2"));
    EXPECT_THAT(judged("MAC702", "O9001\n#5=#2/#501\nM99\n"), IsEmpty());
    EXPECT_THAT(judged("MAC702", "O1\n#101=2.\nG65 P9001 B1.\nM30\nO9001\n#5=#2/#101\nM99\n"), IsEmpty());
}

TEST(DivisionByZero, IsAWarningWhereACallShowsIt) {
    const std::string macro = "O9001\n#5=#2/[#1-#3]\nX#5\nM99\n";
    EXPECT_THAT(judged("MAC702", "O1\nG65 P9001 A2. B1. C2.\nM30\n" + macro), ElementsAre("warning 5"));
    EXPECT_THAT(judged("MAC702", "O1\nG65 P9001 A2. B1. C1.\nM30\n" + macro), IsEmpty());
    EXPECT_THAT(judged("MAC702", "O1\nG65 P9001 A0 B1.\nM30\nO9001\n#5=#2/[#1+#0]\nX#5\nM99\n"),
                ElementsAre("warning 5")); // #0 adds nothing
    EXPECT_THAT(judged("MAC702", "O1\nG65 P9001 A2. B1. C#1\nM30\n" + macro), IsEmpty());
    EXPECT_THAT(
        messages_raised("MAC702", "O1\nG65 P9001 B1. A1.\nG65 P9001 B1.\nM30\nO9001\n#5=#2/#1\nM99\n"),
        ElementsAre(AllOf(HasSubstr("line 3 of O1"), HasSubstr("leaves out #1 (A)"))));
    EXPECT_THAT(judged("MAC702", "O1\nG65 P9001 A0 B1.\nM30\nO9001\nIF[#2GT5]GOTO9\n#5=#2/#1\nN9 M99\n"),
                ElementsAre("note 6")); // B may lead around it
}

TEST(DivisionByZero, ThatNoCallPassesIsNone) {
    const std::string macro = "O9001\n#5=#2/#1\nX#5\nM99\n";
    EXPECT_THAT(judged("MAC702", "O1\nG65 P9001 A2. B1.\nM30\n" + macro), IsEmpty());
    EXPECT_THAT(judged("MAC702", "O1\nIF[#500LE0]GOTO9\nG65 P9001 A#500 B1.\nN9M30\n" + macro), IsEmpty());
    EXPECT_THAT(judged("MAC702", "O1\nG65 P9001 A#500 B1.\nM30\n" + macro), ElementsAre("note 5"));
    EXPECT_THAT(judged("MAC702", "O1\nG65 P9001 A2. B1.\nG65 P9001 A#500 B1.\nM30\n" + macro),
                ElementsAre("note 6"));
}

TEST(DivisionByZero, ByWhatIsCheckedBeforeIsNone) {
    for (const std::string_view check : {"IF[#1EQ0]GOTO9", "IF[ABS[#1]LT0.1]GOTO9", "IF[#1LE0]GOTO9",
                                         "IF[[#1*#2]EQ0]GOTO9", "IF[#1LT#3]GOTO9"})
        EXPECT_THAT(judged("MAC702", "O9001\n" + std::string(check) + "\n#5=#2/#1\nN9 M99\n"), IsEmpty())
            << check;
    EXPECT_THAT(judged("MAC702", "O9001\n#5=#2/#1\nIF[#1EQ0]GOTO9\nN9 M99\n"), ElementsAre("note 2"));
}

TEST(DivisionByZero, IsNotPreventedByAnotherCheck) {
    const std::string alarm = "M99\nN9 #3000=1\n";
    EXPECT_THAT(judged("MAC702", "O9001\nIF[#1EQ#0]GOTO9\n#5=#2/#1\n" + alarm), ElementsAre("warning 3"));
    EXPECT_THAT(judged("MAC702", "O9001\nIF[#1LT0]GOTO9\n#5=#2/#1\n" + alarm), ElementsAre("warning 3"));
    EXPECT_THAT(judged("MAC702", "O9001\nIF[#3EQ#0]GOTO9\n#5=#2/#1\n" + alarm), ElementsAre("warning 3"));
    EXPECT_THAT(judged("MAC702", "O9001\nIF[#1EQ#0]THEN#1=4.\n#5=#2/#1\nM99\n"), ElementsAre("warning 3"));
    EXPECT_THAT(judged("MAC702", "O9001\n#1=4.\nG65P9002\n#5=#2/#1\nM99\n"), IsEmpty());
}

TEST(DivisionByZero, ByWhatIsZeroWithAnArgumentIsANote) {
    const auto divided_by = [](const std::string& divisor) {
        return judged("MAC702", "O9001\n#5=#2/[" + divisor + "]\nM99\n");
    };
    for (const std::string zero : {"2*#1", "#1*2", "#1*#3", "#1/3", "-#1", "ABS[#1]", "SIN[#1]", "TAN[#1]",
                                   "SQRT[#1]", "ROUND[#1]", "FIX[#1]", "FUP[#1]"})
        EXPECT_THAT(divided_by(zero), ElementsAre("note 2")) << zero;
    for (const std::string other : {"COS[#1]", "EXP[#1]", "#1+1", "#1+#3", "#1-1", "#1-#3", "4"})
        EXPECT_THAT(divided_by(other), IsEmpty()) << other;
}

TEST(DivisionByZero, ByAnArgumentIsFollowedTwelveOperationsBack) {
    const auto divided_by = [](int operations, const std::string& begin) {
        std::string text = begin;
        for (int i = 1; i < operations; ++i) text += "#10=#10/2\n";
        return judged("MAC702", text + "#5=3/#10\nX#5\nM99\n").size();
    };
    for (const std::string begin : {"O9001\n#10=#1/2\n", "O1\nG65P9001A2.B2.\nM30\nO9001\n#10=#1-#2\n"}) {
        EXPECT_EQ(divided_by(12, begin), 1U) << begin;
        EXPECT_EQ(divided_by(13, begin), 0U) << begin;
    }
}

TEST(DivisionByZero, ByWhatIsComparedTwelveOperationsOnIsNone) {
    const auto compared_after = [](int operations) {
        std::string text = "O9001\n#10=#1/2\n";
        for (int i = 1; i < operations; ++i) text += "#10=#10/2\n";
        return judged("MAC702", text + "IF[#10GT5]GOTO9\n#5=3/#1\nX#5\nN9M99\n").size();
    };
    EXPECT_EQ(compared_after(12), 0U);
    EXPECT_EQ(compared_after(13), 1U);
}

TEST(DivisionByZero, ByAnArgumentThatMayHaveADefaultIsANote) {
    const auto behind = [](const std::string& blocks) {
        return judged("MAC702", "O9001\n" + blocks + "#5=#2/#1\nM99\n");
    };
    EXPECT_THAT(behind("IF[#3EQ5]THEN#1=4.\n"), ElementsAre("note 3"));
    EXPECT_THAT(behind("IF[#3EQ5]GOTO5\n#1=4.\nN5"), ElementsAre("note 4"));
    EXPECT_THAT(behind("IF[#3EQ5]THEN#1=#6\n"), IsEmpty()); // nothing is known of what it is then
    EXPECT_THAT(behind("#1=4.\nIF[#3EQ5]THEN#1=6.\n"), IsEmpty());
}

TEST(DivisionByZero, IsShownByANumberThatACallCalculates) {
    const auto with = [](const std::string& arguments) {
        return judged("MAC702", "O1\nG65P9001" + arguments + "\nM30\nO9001\n#5=#2/#1\nX#5\nM99\n");
    };
    for (const std::string zero : {"A0B1.", "A[2.-2.]B1.", "A[0*2]B1.", "A[SIN[0]]B1.", "B1."})
        EXPECT_THAT(with(zero), ElementsAre("warning 5")) << zero;
    for (const std::string unknown : {"A#500B1.", "A[#500-#500]B1."})
        EXPECT_THAT(with(unknown), ElementsAre("note 5")) << unknown;
}

TEST(DivisionByZero, TellsWhatTheProgramAsksInstead) {
    const std::string alarm = "\n#5=#2/#1\nM99\nN9 #3000=1\n";
    EXPECT_THAT(messages_raised("MAC702", "O9001\nIF[#1EQ#0]GOTO9" + alarm),
                ElementsAre(HasSubstr("#1 (A) is asked for, not whether it is 0")));
    EXPECT_THAT(messages_raised("MAC702", "O9001\nIF[#1LT0]GOTO9" + alarm),
                ElementsAre(AllOf(HasSubstr("[#1LT0]"), HasSubstr("#1 (A)"))));
    EXPECT_THAT(messages_raised("MAC702", "O9001\nIF[#3EQ#0]GOTO9" + alarm),
                ElementsAre(HasSubstr("checks #3 (C), but not #1 (A)")));
    // It asks for A, and checks C, too: A is what it divides by.
    EXPECT_THAT(messages_raised("MAC702", "O9001\nIF[#3EQ#0]GOTO9\nIF[#1EQ#0]THEN#1=4." + alarm),
                ElementsAre(HasSubstr("#1 (A) is asked for")));
}

TEST(DomainError, OfANegativeNumberIsAnError) {
    EXPECT_THAT(judged("MAC703", "O9001\n#1=-4.\nX[SQRT[#1]]\nM99\n"), ElementsAre("error 3"));
    EXPECT_THAT(judged("MAC703", "O9001\nX[ACOS[1.5]]\nY[ASIN[1]]\nM99\n"), ElementsAre("error 2"));
    EXPECT_THAT(judged("MAC703", "O9001\nIF[#1GE0]GOTO9\nX[SQRT[#1]]\nN9 M99\n"), ElementsAre("error 3"));
    EXPECT_THAT(judged("MAC703", "O9001\nX[SQRT[#1*#1+#2*#2]]\nM99\n"), IsEmpty());
    EXPECT_THAT(judged("MAC703", "O9001\n#1=-0.5\nIF[#2EQ1]THEN#1=0.5\nX[ASIN[#1]]\nM99\n"), IsEmpty());
}

TEST(DomainError, OfADifferenceOfArgumentsThatNothingComparesIsANote) {
    const std::string root = "#5=SQRT[#18*#18-#23*#23]\nM99\n";
    EXPECT_THAT(judged("MAC703", "O9001\n" + root), ElementsAre("note 2"));
    EXPECT_THAT(judged("MAC703", "O9001\nIF[#23GT#18]THEN#3000=1\n" + root), IsEmpty());
    EXPECT_THAT(judged("MAC703", "O9001\nIF[#24LT1]THEN#3000=1\n" + root), ElementsAre("warning 3"));
    EXPECT_THAT(judged("MAC703", "O1\nG65 P9001 R1. W2.\nM30\nO9001\n" + root), ElementsAre("warning 5"));
    EXPECT_THAT(judged("MAC703", "O9001\n#5=SQRT[#18*#18-#5003]\nM99\n"), IsEmpty());
}

TEST(DomainError, IsShownByACallOrToldOfWhatAnArgumentMakes) {
    const auto of = [](const std::string& calculated) {
        return judged("MAC703", "O9001\n#5=" + calculated + "\nX#5\nM99\n");
    };
    for (const std::string argument : {"LN[#1]", "LN[#1*2]", "SQRT[#1-#2]", "SQRT[4-#1]"})
        EXPECT_THAT(of(argument), ElementsAre("note 2")) << argument;
    for (const std::string other :
         {"SQRT[#1]", "SQRT[#1-2]", "SQRT[#1+#2]", "LN[#1+2]", "ACOS[#1]", "ASIN[#1/2]"})
        EXPECT_THAT(of(other), IsEmpty()) << other;
    const auto shown = [](const std::string& calculated) {
        return judged("MAC703", "O1\nG65P9001A-5.B2.\nM30\nO9001\n#5=" + calculated + "\nX#5\nM99\n");
    };
    for (const std::string wrong : {"LN[#1]", "SQRT[#1]", "SQRT[#1+#2]", "ACOS[#1]", "ASIN[#1/2]"})
        EXPECT_THAT(shown(wrong), ElementsAre("warning 5")) << wrong;
    for (const std::string right : {"LN[#2]", "SQRT[#2-1]", "ACOS[#2/2]", "ASIN[#1/5]"})
        EXPECT_THAT(shown(right), IsEmpty()) << right;
}

TEST(TangentOfARightAngle, IsCertainOrOneThatAnArgumentMakes) {
    EXPECT_THAT(judged("MAC704", "O9001\n#1=90.\n#5=TAN[#1]\n#6=TAN[-270]\n#7=TAN[180]\nM99\n"),
                ElementsAre("warning 3", "warning 4"));
    EXPECT_THAT(judged("MAC704", "O9001\n#5=TAN[90-#1]\nM99\n"), ElementsAre("note 2"));
    EXPECT_THAT(judged("MAC704", "O9001\n#5=TAN[45-#1]\n#6=TAN[#1]\nM99\n"), IsEmpty());
    EXPECT_THAT(judged("MAC704", "O1\nG65 P9001 A90.\nM30\nO9001\n#5=TAN[#1]\nM99\n"),
                ElementsAre("warning 5"));
}

TEST(TangentOfARightAngle, IsMadeByAnArgumentThatIsZeroBesideIt) {
    const auto of = [](const std::string& angle) {
        return judged("MAC704", "O9001\n#5=TAN[" + angle + "]\nX#5\nM99\n");
    };
    for (const std::string right : {"90-#1", "90+#1", "#1+90", "#1-90", "#1-270", "90-#1*2"})
        EXPECT_THAT(of(right), ElementsAre("note 2")) << right;
    for (const std::string other : {"45+#1", "90*#1", "#1/90", "180-#1", "#1-#2", "#1"})
        EXPECT_THAT(of(other), IsEmpty()) << other;
}

TEST(DivisionByZero, OfOneStoreIsOneFinding) {
    EXPECT_THAT(lines_raised("MAC702", "O9001\n#1=0\n#5=#2/#1\n#6=#3/#1\nM99\n"), ElementsAre(3));
}

TEST(DivisionByZero, ByVacantIsReportedWhereNobodyElseReportsIt) {
    EXPECT_THAT(messages_raised("MAC702", "O9001\n#5=#2/#0\nM99\n"), ElementsAre(HasSubstr("vacant")));
    EXPECT_THAT(lines_raised("MAC702", "O9001\n#1=#0\n#5=#2/#1\nM99\n"), ElementsAre(3));
    EXPECT_THAT(lines_raised("MAC702", "O9001\nIF[#6NE#0]GOTO1\n#5=#2/#6\nN1 M99\n"), ElementsAre(3));
    for (const std::string_view divided :
         {"#5=5/#33", "#1=#33\n#5=5/#1", "#5=5/[#33*2]", "#5=5/[#33+#32]", "#1=#33+#32\n#4=#1\n#5=5/#4"}) {
        const std::string text = "O1\n" + std::string(divided) + "\nG0 X#5\nM30\n";
        EXPECT_THAT(lines_raised("MAC702", text), IsEmpty()) << text;
        EXPECT_THAT(lines_raised("MAC209", text), Not(IsEmpty())) << text;
    }
}

TEST(DivisionByZero, InALaterPartOfAConditionMayNeverBeComputed) {
    EXPECT_THAT(lines_raised("MAC702", "O9001\n#1=0\nIF[[#1GT0]AND[[#2/#1]GT5]]GOTO9\nN9 M99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC702", "O9001\n#1=0\nIF[[[#2/#1]GT5]AND[#1GT0]]GOTO9\nN9 M99\n"),
                ElementsAre(3));
}

TEST(DivisionByZero, IsNoAngleOfTwoSidesAndNoRemainder) {
    EXPECT_THAT(lines_raised("MAC702", "O9001\n#5=ATAN[1]/[0]\n#6=#2 MOD 0\nM99\n"), IsEmpty());
}

TEST(FloatEquality, OfARoundedResultIsReported) {
    EXPECT_THAT(lines_raised("MAC710", "O9001\n#33=#1/3\nIF[#33EQ#2]GOTO9\nN9 M99\n"), ElementsAre(3));
    EXPECT_THAT(lines_raised("MAC710", "O9001\nIF[SIN[#1]NE0.5]GOTO9\nN9 M99\n"), ElementsAre(2));
    EXPECT_THAT(messages_raised("MAC710", "O9001\n#33=#1/3\nIF[#33EQ60.]GOTO9\nN9 M99\n"),
                ElementsAre(HasSubstr("'#33' is rounded (line 2)")));
    EXPECT_THAT(messages_raised("MAC710", "O9001\n#33=#1/3\nIF[60.NE#33]GOTO9\nN9 M99\n"),
                ElementsAre(HasSubstr("'#33' is rounded (line 2)")));
}

TEST(FloatEquality, OfCopiesHalvesAndWholeNumbersIsExact) {
    EXPECT_THAT(lines_raised("MAC710", "O9001\n#33=#1/3\n#32=#33\nIF[#33EQ#32]GOTO9\nN9 M99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC710", "O9001\nIF[#1/2EQ#2]GOTO9\nN9 M99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC710", "O9001\nIF[FIX[#1/3]EQ2]GOTO9\nN9 M99\n"), IsEmpty());
    const auto in_units = [](const std::string& one, const std::string& other) {
        return lines_raised("MAC710", "O9001\n#33=#1*0.3\nIF[" + one + "EQ" + other + "]GOTO9\nN9 M99\n");
    };
    EXPECT_THAT(in_units("[ROUND[#33*1000]/1000]", "[FIX[#2*1000]/1000]"), IsEmpty());
    EXPECT_THAT(in_units("[ROUND[#33*1000]/1000]", "[ROUND[#2*100]/100]"), ElementsAre(3));
    EXPECT_THAT(in_units("[ROUND[#33*1000]/1000]", "[#2/1000]"), ElementsAre(3));
}

TEST(FloatEquality, WithItsWholePartAsksForAWholeNumber) {
    EXPECT_THAT(lines_raised("MAC710", "O9001\n#33=#1/3\nIF[FIX[#33]NE#33]GOTO9\nN9 M99\n"), IsEmpty());
}

TEST(FloatEquality, OfAProductWithZeroIsExact) {
    EXPECT_THAT(lines_raised("MAC710", "O9001\nIF[#1/3EQ0]GOTO9\nN9 M99\n"), IsEmpty());
}

TEST(FloatEquality, OfASumOfUnknownStepsIsReportedUnlessItIsClamped) {
    EXPECT_THAT(
        lines_raised("MAC710",
                     "O9001\n#33=0\nN1 #33=#33+#17\nIF[#33LT#26]GOTO1\nIF[#33EQ[#26+#17]]GOTO9\nN9 M99\n"),
        ElementsAre(5));
    EXPECT_THAT(lines_raised("MAC710",
                             "O9001\n#33=0\nN1 #33=#33+#17\nIF[#33GT#26]THEN#33=#26\nIF[#33EQ#26]GOTO9\n"
                             "GOTO1\nN9 M99\n"),
                IsEmpty());
    EXPECT_THAT(lines_raised("MAC710", "O9001\n#33=0\nN1 #33=#33+1\nIF[#33EQ#26]GOTO9\nGOTO1\nN9 M99\n"),
                IsEmpty());
}

TEST(ConstantCondition, AfterATestThatTookTheCaseAwayNeverHolds) {
    EXPECT_THAT(lines_raised("MAC718", "O9001\nIF[#6GT5]GOTO1\nIF[#6GT10]GOTO2\nM99\nN1 M99\nN2 M99\n"),
                ElementsAre(3));
}

TEST(ConstantCondition, TheLastOfAllCasesMayBeTested) {
    EXPECT_THAT(lines_raised("MAC718", "O9001\nIF[#6GT5]GOTO1\nIF[#6LE5]GOTO2\nM99\nN1 M99\nN2 M99\n"),
                IsEmpty());
}

TEST(ConstantCondition, ThatSendsToTheSamePlaceDoesNoHarm) {
    EXPECT_THAT(lines_raised("MAC718", "O9001\nIF[#6LE#0]GOTO1\nIF[#6LE0]GOTO1\nM99\nN1 M99\n"), IsEmpty());
}

TEST(ConstantCondition, OfASettingIsForTheUserToChange) {
    EXPECT_THAT(lines_raised("MAC718", "O1\n#100=1(1 WITH PROBE)\nIF[#100EQ1]GOTO1\nG0 X1\nN1 M30\n"),
                IsEmpty());
    EXPECT_THAT(
        lines_raised("MAC718",
                     "O1\n#2=-24\n#1=-5\nWHILE[#1GT#2]DO1\n#1=#1-1\nIF[#1LT#2]THEN#1=#2\nEND1\nM30\n"),
        IsEmpty());
}

TEST(ConstantCondition, OfAVariableThatWasSetAnewIsASetting) {
    EXPECT_THAT(lines_raised("MAC718", "O1\n#100=#500\n#100=4\nIF[#100NE4]GOTO1\nG0 X1\nN1 M30\n"),
                IsEmpty());
}

TEST(ConstantCondition, LeavesEndlessLoopsAndVacancyToOthers) {
    EXPECT_THAT(lines_raised("MAC718", "O1\nWHILE[1EQ1]DO1\nG0 X#500\nIF[#500EQ1]GOTO9\nEND1\nN9 M30\n"),
                IsEmpty());
    EXPECT_THAT(lines_raised("MAC718", "O1\n#1=5\nIF[#1EQ#0]GOTO9\nN9 M30\n"), IsEmpty());
}

TEST(ConstantCondition, ConditionsJoinedByOrMayLeaveNothing) {
    EXPECT_THAT(lines_raised("MAC718", "O9001\nIF[[#1LT8]OR[#1GT6]]GOTO9\nG0 X1\nN9 M99\n"), ElementsAre(2));
    EXPECT_THAT(lines_raised("MAC718", "O9001\nIF[[#1NE1]OR[#1NE2]]GOTO9\nG0 X1\nN9 M99\n"), ElementsAre(2));
    EXPECT_THAT(lines_raised("MAC718", "O9001\nIF[[#1LT6]OR[#1GT8]]GOTO9\nG0 X1\nN9 M99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC718", "O9001\nIF[[#1EQ1]OR[#2NE1]]GOTO9\nG0 X1\nN9 M99\n"), IsEmpty());
}

TEST(ConstantCondition, ConditionsJoinedByAndMayExcludeEachOther) {
    EXPECT_THAT(lines_raised("MAC718", "O9001\nIF[[#1LT6]AND[#1GT8]]GOTO9\nG0 X1\nN9 M99\n"), ElementsAre(2));
    EXPECT_THAT(lines_raised("MAC718", "O9001\nIF[[#1EQ6]AND[#1EQ8]]GOTO9\nG0 X1\nN9 M99\n"), ElementsAre(2));
    EXPECT_THAT(lines_raised("MAC718", "O9001\nIF[[#1GT6]AND[#1LT8]]GOTO9\nG0 X1\nN9 M99\n"), IsEmpty());
}

TEST(ConstantCondition, AfterALoopThatCannotBeReadProvesNothing) {
    EXPECT_THAT(lines_raised("MAC718", "O1\n#28=1\nWHILE[#28LT5]]DO1\nIF[#28LT5000]GOTO9\n#28=#28+1\nEND1\n"
                                       "N9 M30\n"),
                IsEmpty());
}

TEST(ConstantCondition, OfSettingsIsMeant) {
    const auto decided_by = [](std::string_view settings, std::string_view condition) {
        return "O9001\n" + std::string(settings) + "\nIF[" + std::string(condition) +
               "]GOTO6\nG0X1.\nN6#101=#24\n#6=#24\nM99\nO9750\n#143=0.(SETTING)\nM99\n";
    };
    EXPECT_THAT(lines_raised("MAC718", decided_by("#101=10.(HEIGHT)", "#101GT0")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC718", decided_by("#14=1.(X)\n#15=2.(Y)\n#6=#14+#15", "#6EQ0")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC718", decided_by("M98P9750", "#143EQ0")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC718", decided_by("M98P9750\n#6=#143*2", "#6EQ0")), IsEmpty());
}

TEST(ConstantCondition, OfWhatIsMadeOfASettingInFewStepsIsMeant) {
    const auto steps = [](int count) {
        std::string text = "O9001\n#6=1.(HEIGHT)\n";
        for (int i = 0; i < count; ++i) text += "#6=#6*2\n";
        return lines_raised("MAC718", text + "IF[#6EQ0]GOTO6\nG0X1.\nN6#101=#6\n#6=#24\nX#6\nM99\n").size();
    };
    EXPECT_EQ(steps(1), 0U);
    EXPECT_EQ(steps(7), 0U);
    EXPECT_EQ(steps(8), 1U);
}

TEST(ConstantCondition, OnlyATestThatDecidesItIsItsReason) {
    const auto message = [](const std::string& text) {
        const auto messages = messages_raised("MAC718", "O9001\n" + text + "N9M99\n");
        return messages.size() == 1 ? messages.front() : "";
    };
    // Whether #2 was 5 or not, it is not 12.
    EXPECT_THAT(
        message("#2=0\nWHILE[#2LT9]DO1\n#2=#2+1\nIF[#2EQ5]THEN#3=1\nIF[#2EQ12]THEN#4=1\nEND1\nX#3Y#4\n"),
        HasSubstr("because of the test '[#2LT9]' on line 3"));
    EXPECT_THAT(message("WHILE[#2GT3]DO1\n#2=#2-1\nEND1\nIF[#2GT3]THEN#4=1\nX#4\n"),
                HasSubstr("because of the test '[#2GT3]' on line 2"));
    EXPECT_THAT(message("IF[#2LE3]GOTO1\nX1.\nIF[#2LT2]THEN#4=1\nX#4\nN1\n"),
                HasSubstr("because of the test '[#2LE3]' on line 2"));
    EXPECT_THAT(
        message("#1=10\n#2=0\nWHILE[#2LT#1]DO1\n#2=#2+1\nIF[#2EQ5]THEN#3=1\nIF[#2EQ12]THEN#4=1\nEND1\n"
                "X#3Y#4\n"),
        AllOf(HasSubstr("never true: '[#2EQ12]'"), Not(HasSubstr("#2EQ5"))));
}

TEST(ConstantCondition, AGuardAgainstTheLastDigitIsMeant) {
    const auto raised = [](const std::string& condition) {
        return lines_raised("MAC718", "O9001\n#1=0\nWHILE[#1LE30]DO1\n#2=1-#1*#1/900\n#4=0\nIF[" + condition +
                                          "]THEN#4=1\nX#2Y#4\n#1=#1+1\nEND1\nM99\n");
    };
    EXPECT_THAT(raised("#2LT0"), IsEmpty());
    EXPECT_THAT(raised("#2LT-1"), ElementsAre(6));
}

TEST(ConstantCondition, OfWhatATestHasFoundOutIsNone) {
    EXPECT_THAT(messages_raised("MAC718",
                                "O9001\n#33=#1\nIF[#33NE5]GOTO9\nG0X1.\nIF[#33GT5]GOTO8\nG0X2.\nN8G0X3.\n"
                                "N9M99\n"),
                ElementsAre(AllOf(HasSubstr("never true"), HasSubstr("#33 is 5"))));
    EXPECT_THAT(messages_raised("MAC718", "O9001\nIF[#6GT5]GOTO1\nIF[#6GT10]GOTO2\nM99\nN1 M99\nN2 M99\n"),
                ElementsAre(AllOf(HasSubstr("[#6GT5]"), HasSubstr("line 2"))));
}

TEST(ConstantCondition, AfterAnotherWithTheSameTargetLeavesNothingToRun) {
    EXPECT_THAT(lines_raised("MAC718", "O9001\nIF[#6GT1]GOTO3\nIF[#6NE4]GOTO3\nG0X1.\nN3M99\n"),
                ElementsAre(3));
    EXPECT_THAT(lines_raised("MAC718", "O9001\nIF[#6NE1]GOTO3\nIF[#6NE4]GOTO3\nG0X1.\nN3M99\n"),
                ElementsAre(3));
    EXPECT_THAT(lines_raised("MAC718", "O9001\nIF[#6LT1]GOTO3\nIF[#6GT4]GOTO3\nG0X1.\nN3M99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC718", "O9001\nIF[#6GT1]GOTO3\nIF[#6LE1]GOTO4\nN4G0X1.\nN3M99\n"), IsEmpty());
}

TEST(ConstantCondition, ThatDoesWhatAnotherDoesIsHarmless) {
    EXPECT_THAT(lines_raised("MAC718", "O9001\nIF[#6LT50]GOTO9\nIF[#6LT40]THEN#31=-1\nIF[#6LT60]THEN#31=-1\n"
                                       "G0X#31\nN9M99\n"),
                IsEmpty());
    EXPECT_THAT(lines_raised("MAC718", "O9001\nIF[#6LT50]GOTO9\nIF[#6LT40]THEN#31=-2\nIF[#6LT60]THEN#31=-1\n"
                                       "G0X#31\nN9M99\n"),
                ElementsAre(3));
}

TEST(ConstantCondition, IsToldWhateverItGuards) {
    const auto guarded = [](std::string_view what) {
        return "O9001\nIF[#6GT50]GOTO9\nIF[#6GT60]THEN" + std::string(what) + "\nG0X#6Y#7\nN9M99\n";
    };
    for (const std::string_view what : {"#6=60", "#7=60", "#[6]=60"})
        EXPECT_THAT(lines_raised("MAC718", guarded(what)), ElementsAre(3)) << what;
}

TEST(ConstantCondition, OfAGuardThatIsThereTwice) {
    const auto guards = [](std::string_view first, std::string_view between, std::string_view second) {
        return "O9001\nIF[" + std::string(first) + "\n" + std::string(between) + "IF[" + std::string(second) +
               "\nG0X#24Y#25Z#26\nM99\nN8 M99\nN9#3000=1(MISSING)\n";
    };
    const auto raised = [&](std::string_view first, std::string_view between, std::string_view second) {
        return lines_raised("MAC718", guards(first, between, second)).size();
    };
    EXPECT_EQ(raised("#24EQ#0]GOTO9", "", "#24EQ#0]GOTO9"), 1U);
    EXPECT_EQ(raised("#24EQ#0]GOTO9", "", "#24EQ#0]GOTO8"), 1U);
    EXPECT_EQ(raised("#24EQ5]GOTO9", "", "#24EQ5]GOTO9"), 1U);
    EXPECT_EQ(raised("#1EQ1]GOTO8\nIF[#24EQ#0]GOTO9", "", "#24EQ#0]GOTO8"), 1U);
    EXPECT_EQ(raised("#24EQ#0]GOTO9", "", "#24EQ#0]GOTO9\nIF[#1EQ1]]GOTO9"), 1U); // an open loop is no matter
    EXPECT_EQ(raised("#24EQ#0]THEN#3000=1", "", "#24EQ#0]THEN#3000=1"), 1U);
    EXPECT_EQ(raised("#24EQ#0]GOTO9", "IF[#25EQ#0]GOTO9\n", "#24EQ#0]GOTO9"), 1U);
    EXPECT_EQ(raised("#24EQ#0]GOTO9", "IF[#7EQ#0]THEN#7=1.\n", "#24EQ#0]GOTO9"), 1U);
    EXPECT_EQ(raised("#24EQ#0]GOTO9", "#1=#24\n", "#24EQ#0]GOTO9"), 1U);
    EXPECT_EQ(raised("#24EQ#0]GOTO9", "", "#25EQ#0]GOTO9"), 0U);
    EXPECT_EQ(raised("#24EQ#0]GOTO9", "#24=#1\n", "#24EQ#0]GOTO9"), 0U);
    EXPECT_EQ(raised("#24EQ#0]GOTO9", "IF[#7EQ#0]THEN#24=#1\n", "#24EQ#0]GOTO9"), 0U);
    EXPECT_EQ(raised("#24EQ#0]GOTO9", "G0X1.\n", "#24EQ#0]GOTO9"), 0U);
    EXPECT_EQ(raised("#24EQ#0]GOTO9", "IF[#7EQ1]GOTO5\n#24=#1\nN5", "#24EQ#0]GOTO9"), 0U);
    EXPECT_EQ(raised("#1000EQ0]GOTO9", "", "#1000EQ0]GOTO9"), 0U); // an input may change in between
    EXPECT_EQ(raised("#24EQ1]THEN#1=1", "", "#24EQ1]THEN#2=1"), 0U);
}

TEST(ConstantCondition, NamesWhatNoTestAsksFor) {
    EXPECT_THAT(messages_raised("MAC718", "O9001\nIF[#24EQ#0]GOTO9\nIF[#24EQ#0]GOTO9\nIF[#26EQ#0]GOTO9\n"
                                          "G0X#24Y#25Z#26\nM99\nN9#3000=1(MISSING)\n"),
                ElementsAre(AllOf(HasSubstr("line 2 asks the same"), HasSubstr("(nothing tests #25 (Y))"))));
    EXPECT_THAT(messages_raised("MAC718", "O9001\nIF[#24EQ#0]GOTO9\nIF[#24EQ#0]GOTO9\nG0X#24\nM99\n"
                                          "N9#3000=1(MISSING)\n"),
                ElementsAre(Not(HasSubstr("nothing tests"))));
}

TEST(ConstantCondition, ThatAGuardDecidesIsNoMatterOfSettings) {
    EXPECT_THAT(lines_raised("MAC718", "O9001\n#6=1.\nIF[#6GT1]GOTO3\nIF[#6NE4]GOTO3\nG0X1.\nN3M99\n"),
                ElementsAre(4));
    EXPECT_THAT(
        lines_raised("MAC718", "O9001\n#6=1.\nIF[#6GT5]GOTO3\nIF[#6GT10]GOTO4\nG0X1.\nN3M99\nN4M99\n"),
        ElementsAre(4));
    EXPECT_THAT(lines_raised("MAC718", "O9001\n#6=1.\nIF[#6GT5]GOTO3\nIF[#6GT4]GOTO4\nG0X1.\nN3M99\nN4M99\n"),
                IsEmpty());
    // the limits of the mould are asked once more for each of two variables
    EXPECT_THAT(lines_raised("MAC718", "O9001\nIF[#6LT54]GOTO9\nIF[#6LT54]THEN#31=-1\nIF[#6LT55]THEN#31=-1\n"
                                       "G0X#31\nN9M99\n"),
                IsEmpty());
}

TEST(ConstantCondition, ThatItsOwnPartsDecideHasNoOtherReason) {
    EXPECT_THAT(messages_raised("MAC718", "O9001\nIF[#1EQ6]GOTO9\nIF[[#1LT8]OR[#1GT6]]GOTO9\nG0X1\nN9M99\n"),
                ElementsAre(HasSubstr("whatever the values are")));
}

TEST(FloatEquality, WithZeroIsSafeWhereRoundingCannotMakeIt) {
    const auto asked = [](std::string_view expression) {
        return "O9001\n#33=" + std::string(expression) + "\nIF[#33EQ0]GOTO9\nG0X[1/#33]\nN9 M99\n";
    };
    for (const std::string_view safe :
         {"SQRT[#1*#1+#2*#2]", "ABS[#1/3]", "[#1-#2]/3", "SQRT[#1]*#2", "FIX[#1/3]", "-[#1/#2]",
          "ROUND[#1/3]", "FUP[#1/3]", "#1/3*[#2/3]", "ABS[#1/3]+2", "ABS[#1/3]+ABS[#2/3]",
          "[ABS[#1/3]+ABS[#2/3]]+SQRT[#3]", "SQRT[#3]+[ABS[#1/3]+ABS[#2/3]]", "#1*#1+ABS[#3/3]"})
        EXPECT_THAT(lines_raised("MAC710", asked(safe)), IsEmpty()) << safe;
    for (const std::string_view unsafe :
         {"ABS[COS[#1]]", "#1/3-#2", "SQRT[#1*#1-#2*#2/3]", "SIN[#1]*#2", "#1*0.1-#2", "-[#1/3-#2]",
          "[#1/3-#2]/3", "[#1/3]*SIN[#1]", "SIN[#1]*[#1/3]", "ABS[#3/3]+#2", "#1/3+2", "#1*#2+ABS[#3/3]",
          "[ABS[#1/3]-ABS[#2/3]]+ABS[#3]", "[ABS[#1/3]*ABS[#2/3]]+ABS[#3]"})
        EXPECT_THAT(lines_raised("MAC710", asked(unsafe)), ElementsAre(3)) << unsafe;
}

TEST(FloatEquality, OfADistanceToNothingIsReported) {
    EXPECT_THAT(lines_raised("MAC710", "O9001\nIF[ABS[#18-#5043]EQ0]GOTO9\nG0X1.\nN9 M99\n"), ElementsAre(2));
    EXPECT_THAT(lines_raised("MAC710", "O9001\nIF[ABS[#18-#5043]NE0]GOTO9\nG0X1.\nN9 M99\n"), ElementsAre(2));
    EXPECT_THAT(lines_raised("MAC710", "O9001\nIF[ABS[#18-#5043]LE0.01]GOTO9\nG0X1.\nN9 M99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC710", "O9001\nIF[ABS[#4120-#4111]EQ0]GOTO9\nG0X1.\nN9 M99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC710", "O9001\nIF[ABS[#18]EQ0]GOTO9\nG0X1.\nN9 M99\n"), IsEmpty());
}

TEST(FloatEquality, OfADistanceToNothingIsToldOnEitherSide) {
    const auto told = [](const std::string& condition) {
        return messages_raised("MAC710", "O9001\nIF[" + condition + "]GOTO9\nG0X1.\nN9 M99\n");
    };
    for (const std::string condition : {"ABS[#18-#5043]EQ0", "0EQABS[#18-#5043]"})
        EXPECT_THAT(told(condition), ElementsAre(HasSubstr("Distance of exactly 0: in '[" + condition)));
    EXPECT_THAT(told("1EQABS[#18-#5043]"), IsEmpty());
}

TEST(FloatEquality, OfSumsWithZeroIsFollowedSixteenOperationsDeep) {
    // #10 is rounded on both paths, and by which operation is not known where they meet.
    const auto asked = [](int operations, const std::string& next) {
        std::string text = "O9001\nIF[#3EQ1]GOTO5\n#10=#1/3\nGOTO6\nN5#10=#2/3\nN6";
        for (int i = 0; i < operations; ++i) text += next;
        return lines_raised("MAC710", text + "IF[#10EQ0]GOTO9\nG0X1.\nN9M99\n").size();
    };
    for (const std::string next : {"#10=#10-#7\n", "#10=#7-#10\n", "#10=#10+#7\n", "#10=#7+#10\n"}) {
        EXPECT_EQ(asked(1, next), 0U) << next;
        EXPECT_EQ(asked(16, next), 0U) << next;
        EXPECT_EQ(asked(17, next), 1U) << next;
    }
    EXPECT_EQ(asked(0, ""), 1U);
    EXPECT_EQ(asked(2, "#10=#10-0.1\n"), 1U);
    EXPECT_EQ(asked(2, "#10=#10-2\n"), 0U);
    EXPECT_EQ(asked(2, "#10=#10*#7-#7\n"), 1U);
}

TEST(FloatEquality, OfQuotientsAndProductsWithZeroIsFollowedSixteenOperationsDeep) {
    const auto asked = [](int operations, const std::string& next) {
        std::string text = "O9001\n#10=#1/3\n";
        for (int i = 1; i < operations; ++i) text += next;
        return lines_raised("MAC710", text + "IF[#10EQ0]GOTO9\nG0X1.\nN9M99\n").size();
    };
    for (const std::string next : {"#10=#10/3\n", "#10=#10*#2\n", "#10=#2*#10\n"}) {
        EXPECT_EQ(asked(16, next), 0U) << next;
        EXPECT_EQ(asked(17, next), 1U) << next;
    }
}

TEST(FloatEquality, WithTheWholePartAsksWhetherAQuotientOfDecimalsIsWhole) {
    EXPECT_THAT(lines_raised("MAC710", "O9001\n#33=#26/#17\nIF[#33EQFIX[#33]]GOTO9\nG0X1.\nN9 M99\n"),
                ElementsAre(3));
    EXPECT_THAT(lines_raised("MAC710", "O9001\n#33=#26/0.3\nIF[#33EQFIX[#33]]GOTO9\nG0X1.\nN9 M99\n"),
                ElementsAre(3));
    EXPECT_THAT(lines_raised("MAC710", "O9001\n#33=#26/10\nIF[#33EQFIX[#33]]GOTO9\nG0X1.\nN9 M99\n"),
                IsEmpty());
}

TEST(FloatEquality, OfASumOfTwoWrittenNumbersIsExactWhereItIsTheWrittenSum) {
    EXPECT_THAT(lines_raised("MAC710", "O9001\nIF[#5004EQ[-0.642-2.130]]GOTO9\nN9 M99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC710", "O9001\nIF[#5004EQ[0.1+0.2]]GOTO9\nN9 M99\n"), ElementsAre(2));
    EXPECT_THAT(lines_raised("MAC710", "O9001\nIF[#5004EQ[-0.642+#500]]GOTO9\nN9 M99\n"), ElementsAre(2));
}

TEST(InputOfTheMachine, ChangesWhereALoopWaitsForIt) {
    const std::string later = "N81G31X1.\nIF[#1006EQ1]GOTO230\n#3000=10\nN230#734=[#732+#733]/0\nM99\n";
    EXPECT_THAT(
        lines_raised("MAC702", "O8750\nIF[#1006EQ1]GOTO72\nGOTO81\nN72M1\nIF[#1006EQ1]GOTO72\n" + later),
        ElementsAre(9));
    // Whoever only asks one twice takes it for a switch.
    EXPECT_THAT(lines_raised("MAC702", "O8750\nIF[#1006EQ1]GOTO81\nM30\nN81G31X1.\nIF[#1006EQ1]GOTO230\n"
                                       "#734=[#732+#733]/0\nN230M99\n"),
                IsEmpty());
}

} // namespace
} // namespace maclint
