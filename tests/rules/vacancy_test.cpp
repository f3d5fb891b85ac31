//! Rules about vacant variables: MAC209, MAC220, MAC225, MAC221, MAC222, MAC228, MAC604.
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
using ::testing::SizeIs;

TEST(UninitialisedLocal, IsReportedOnceWithTheProgramAsItsOrigin) {
    EXPECT_THAT(lines_raised("MAC209", "O1\nG0 X#5\nG0 Y#5\nM30\n"), ElementsAre(2));
    EXPECT_THAT(path_raised("MAC209", "O1\nG0 X#5\nM30\n"), ElementsAre(1, 2));
}

TEST(UninitialisedLocal, IsReportedWithTheBlockThatIsSkipped) {
    EXPECT_THAT(path_raised("MAC209", "O1\nG0 Y#500\n/#5=1\nG0 X#5\nM30\n"), ElementsAre(1, 3, 4));
    EXPECT_THAT(path_raised("MAC209", "O1\n/#5=1\nG0 X#5\nM30\n"), ElementsAre(1, 2, 3));
    EXPECT_THAT(path_raised("MAC209", "O1\nG0 Y#500\n/#5=1\n/#6=1\nG0 X#5\nM30\n"), ElementsAre(1, 3, 5));
}

TEST(UninitialisedLocal, IsNotAnArgumentLetterOfAProgramThatIsCalled) {
    EXPECT_THAT(lines_raised("MAC209", "O9001\nG0 X#24\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC209", "O9001\nG0 X#24 Y#10\nM99\n"), ElementsAre(2));
}

TEST(UninitialisedLocal, IsNoneWhenAProgramTakesASeriesOfIJAndK) {
    const std::string series = "G0 X#4 Y#5 Z#6\nX#7 Y#8 Z#9\nX#10 Y#11 Z#12\nX#13 Y#14 Z#15\n";
    EXPECT_THAT(lines_raised("MAC209", "O9001\n" + series + "M99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC209", "O9001\n" + series + "X#33\nM99\n"), ElementsAre(6));
    EXPECT_THAT(messages_raised("MAC209", "O9001\nG0 X#10 Y#11 Z#12\nM99\n"),
                ElementsAre(HasSubstr("#10 and #12")));
    EXPECT_THAT(messages_raised("MAC209", "O9001\nG0 X#24 Y#10\nM99\n"),
                ElementsAre(HasSubstr("unless I, J and K are repeated")));
}

TEST(UninitialisedLocal, MayBeSetByTheCallerOfASubprogram) {
    EXPECT_THAT(lines_raised("MAC209", "O1\n#10=5\nM98 P2\nM30\nO2\nG0 X#10\nM99\n"), IsEmpty());
}

TEST(UninitialisedLocal, IsNoVacancyTestAndNoCountFromVacant) {
    EXPECT_THAT(lines_raised("MAC209", "O1\nIF[#5EQ#0]GOTO9\nN9 M30\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC209", "O1\nN1 #5=#5+1\nIF[#5LT4]GOTO1\nM30\n"), IsEmpty());
}

TEST(Messages, NameTheArgumentOfAMacroBesideItsVariable) {
    const std::string body = "IF[#6LT0]GOTO9\nG1 Z#6\n";
    EXPECT_THAT(messages_raised("MAC221", "O1\n" + body + "N9 M99\n"),
                ElementsAre(HasSubstr("takes a vacant #6 (K) for 0, and #6 (K) is used")));
}

TEST(UninitialisedLocal, WithoutAFirstValueKeepsALoopFromItsFirstPass) {
    const std::string down = "WHILE[#5GT0]DO1\nG1Z#5F100\n#5=#5-1\nEND1\nM30\n";
    EXPECT_THAT(lines_raised("MAC209", "O1\n#6=3\n" + down), ElementsAre(3));
    EXPECT_THAT(lines_raised("MAC209", "O1\n#5=3\n" + down), IsEmpty());
    // What is compared before it is set for the first time may be a flag.
    EXPECT_THAT(lines_raised("MAC209", "O1\nIF[#5GT0]GOTO2\n#5=1\nN2G0X1.\nM30\n"), IsEmpty());
    // Up from vacant is up from 0.
    EXPECT_THAT(lines_raised("MAC209", "O1\nWHILE[#5LT3]DO1\n#5=#5+1\nEND1\nM30\n"), IsEmpty());
}

TEST(UninitialisedLocal, SetOnOneWayOnlyIsToldWithTheOtherWay) {
    const std::string text = "O1\nIF[#1004EQ1]GOTO3\n#31=5\nN3 G0 X#31\nM30\n";
    EXPECT_THAT(messages_raised("MAC209", text), ElementsAre(HasSubstr("here, depending on #1004")));
    EXPECT_THAT(path_raised("MAC209", text), ElementsAre(1, 2, 4));
}

TEST(UninitialisedLocal, NeedsAWayWhoseTestsDoNotContradictEachOther) {
    // The same test decides whether it is set and whether it is read.
    EXPECT_THAT(lines_raised("MAC209",
                             "O1\nIF[#4111EQ50]GOTO3\n#31=5\nN3 IF[#4111NE50]GOTO4\nM30\nN4 G0 X#31\nM30\n"),
                IsEmpty());
    // One of the two always sets it.
    EXPECT_THAT(
        lines_raised("MAC209", "O1\nIF[#500GT#501]THEN#32=1\nIF[#500LE#501]THEN#32=2\nG0 X#32\nM30\n"),
        IsEmpty());
    // No whole number is left, and a PMC input is 0 or 1.
    EXPECT_THAT(lines_raised("MAC209", "O1\nIF[#500LT1]GOTO9\nIF[#500GT2]GOTO9\nIF[#500EQ1]THEN#32=1\n"
                                       "IF[#500EQ2]THEN#32=2\nG0 X#32\nN9 M30\n"),
                IsEmpty());
    EXPECT_THAT(lines_raised("MAC209", "O1\nIF[#1000EQ0]THEN#32=1\nIF[#1000EQ1]THEN#32=2\nG0 X#32\nM30\n"),
                IsEmpty());
    EXPECT_THAT(lines_raised("MAC209", "O1\nIF[#500EQ0]THEN#32=1\nIF[#500EQ1]THEN#32=2\nG0 X#32\nM30\n"),
                ElementsAre(4));
}

TEST(ZeroTest, MissesAnArgumentThatIsNotPassed) {
    EXPECT_THAT(lines_raised("MAC220", "O9001\nIF[#6EQ0]GOTO9\nG0 Z[#6*2]\nN9 M99\n"), ElementsAre(2));
    EXPECT_THAT(messages_raised("MAC220", "O9001\nIF[0 NE #6]GOTO9\nM99\nN9 G0 Z[#6*2]\nM99\n"),
                ElementsAre(HasSubstr("Check passed when #6 (K) is left out")));
}

TEST(ZeroTest, BesideAVacancyTestTreatsBothCases) {
    EXPECT_THAT(lines_raised("MAC220", "O9001\nIF[#6EQ#0]GOTO9\nIF[#6EQ0]GOTO9\nN9 M99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC220", "O9001\nIF[#6EQ0]GOTO9\nIF[#6EQ#0]GOTO9\nN9 M99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC220", "O9001\nIF[[#6EQ0]OR[#6EQ#0]]GOTO9\nN9 M99\n"), IsEmpty());
}

TEST(ZeroTest, InAChoiceAmongNumbersIsNoCheck) {
    EXPECT_THAT(lines_raised("MAC220", "O9001\nIF[#3EQ0]GOTO1\nIF[#3EQ1]GOTO2\nN1 M99\nN2 M99\n"), IsEmpty());
}

TEST(RangeTest, IsPassedByAMissingArgumentThatIsUsedLater) {
    EXPECT_THAT(lines_raised("MAC221", "O9001\nIF[#6LT0]GOTO9\nG0 Z#6\nN9 M99\n"), ElementsAre(2));
    EXPECT_THAT(lines_raised("MAC221", "O9001\nIF[#6LE0]GOTO9\nG0 Z#6\nN9 M99\n"), IsEmpty());
}

TEST(VacancyTest, OfArithmeticNeverHolds) {
    EXPECT_THAT(lines_raised("MAC222", "O9001\nIF[[#1+0]EQ#0]GOTO9\nIF[#0NE-#1]GOTO9\nN9 M99\n"),
                ElementsAre(2, 3));
    EXPECT_THAT(lines_raised("MAC222", "O9001\nIF[[#1]EQ#0]GOTO9\nN9 M99\n"), IsEmpty());
}

TEST(VacancyTest, NeverHoldsWhenEveryWaySetsTheVariable) {
    EXPECT_THAT(lines_raised("MAC228", "O9001\n#5=#1*2\nIF[#5EQ#0]GOTO9\nN9 M99\n"), ElementsAre(3));
    EXPECT_THAT(
        lines_raised("MAC228", "O9001\nIF[#1GT0]GOTO1\n#5=1\nGOTO2\nN1 #5=2\nN2 IF[#5EQ#0]GOTO9\nN9 M99\n"),
        ElementsAre(6));
}

TEST(VacancyTest, MayHoldForACopyOfAnArgumentAndForWhatOthersSet) {
    EXPECT_THAT(lines_raised("MAC228", "O9001\n#33=#1\nIF[#33EQ#0]GOTO9\nN9 M99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC228", "O9001\nIF[#500EQ#0]GOTO9\nIF[#500EQ#0]GOTO9\nN9 M99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC228", "O9001\nIF[#1EQ#0]THEN#1=5\nIF[#1EQ#0]GOTO9\nN9 M99\n"), IsEmpty());
    // Asked of the variable that was copied, and of the copy.
    const std::string tested = "O9001\nIF[#500EQ#0]GOTO9\n#5=#500";
    EXPECT_THAT(judged("MAC228", tested + "\nIF[#5EQ#0]GOTO9\nN9 M99\n"), ElementsAre("note 4"));
    EXPECT_THAT(judged("MAC228", tested + "*2\nIF[#5EQ#0]GOTO9\nN9 M99\n"), ElementsAre("warning 4"));
}

TEST(VacancyTest, ThatSetsWhatItIsAlreadyIsFine) {
    EXPECT_THAT(judged("MAC228", "O9001\n#5=FUP[#6]\nIF[#5EQ#0]THEN#5=0\nX#5\nM99\n"), IsEmpty());
    EXPECT_THAT(judged("MAC228", "O9001\n#5=FUP[#6]\nIF[#5EQ#0]THEN#5=2\nX#5\nM99\n"), ElementsAre("note 3"));
    EXPECT_THAT(judged("MAC228", "O9001\n#5=FUP[#6]\nIF[#5EQ#0]THEN#7=0\nX#5\nM99\n"),
                ElementsAre("warning 3"));
}

TEST(UninitialisedLocal, ATestOfAnotherVariableOnTheWayIsHeeded) {
    // #31 and #32 are set under the same tests: where #31 is not vacant, #32 is not either.
    const std::string program = "O9001\nIF[#1EQ1]GOTO1\nIF[#1EQ2]GOTO2\nGOTO3\n"
                                "N1 #32=1\n#31=1\nGOTO3\nN2 #32=2\n#31=2\nN3\n";
    EXPECT_THAT(lines_raised("MAC209", program + "IF[#31EQ#0]GOTO9\nG0 X#32\nN9 M99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC209", program + "G0 X#32\nN9 M99\n"), ElementsAre(11));
}

TEST(UninitialisedLocal, IsLookedForBehindAReadToWhichNoPathLeadsWithoutAValue) {
    EXPECT_THAT(lines_raised("MAC209", "O1\nIF[#501EQ1]GOTO1\n#30=1\nN1 IF[#501EQ1]GOTO2\nG0 X#30\n"
                                       "N2 G0 Y#30\nM30\n"),
                ElementsAre(6));
}

TEST(UninitialisedLocal, AnIndexMadeOfAVacantVariableIsToldThere) {
    EXPECT_THAT(lines_raised("MAC209", "O1\nG0 X#[#31+10]\nM30\n"), ElementsAre(2));
    EXPECT_THAT(messages_raised("MAC209", "O1\nG0 X#[#31+10]\nM30\n"),
                ElementsAre(::testing::HasSubstr("set #31 before")));
}

TEST(UninitialisedLocal, IsToldOnceForAllThatOneCaseLeavesUnset) {
    const std::string table = "O9001(C#3)\nIF[#4120EQ12]THEN#31=#3\nIF[#4120EQ12]THEN#32=4\n"
                              "IF[#4120EQ11]THEN#31=1\nIF[#4120EQ11]THEN#32=3\n";
    EXPECT_THAT(
        messages_raised("MAC209", table + "G0 X#31\nY#32\nM99\n"),
        ElementsAre(HasSubstr("Variables #31 and #32 may be vacant here: set only for #4120 = 11 or 12.")));
    // Two cases are two mistakes.
    EXPECT_THAT(lines_raised("MAC209", table + "IF[#4111EQ5]THEN#33=1\nG0 X#31\nY#33\nM99\n"),
                ElementsAre(7, 8));
    // Refused, there is no such case.
    EXPECT_THAT(lines_raised("MAC209", table + "IF[#4120LT11]GOTO9\nIF[#4120GT12]GOTO9\nG0 X#31\nM99\n"
                                               "N9 #3000=1(TOOL)\n"),
                IsEmpty());
}

TEST(UninitialisedLocal, DependsOnMoreThanNumbersWhereAnotherTestDecidesAsWell) {
    const auto told = [](const std::string& tests) {
        return messages_raised("MAC209", "O1\n" + tests + "G0 X#31\nM30\n");
    };
    EXPECT_THAT(told("IF[#4120EQ12]THEN#31=3\n"), ElementsAre(HasSubstr("set only for #4120 = 12.")));
    for (const std::string other : {"#500", "#4120GT15", "[#4120EQ11]AND[#500EQ1]", "#4120NE11"})
        EXPECT_THAT(told("IF[" + other + "]THEN#31=3\nIF[#4120EQ12]THEN#31=3\n"),
                    ElementsAre(HasSubstr("depending on #4120")))
            << other;
    EXPECT_THAT(told("IF[[#4120EQ11]OR[#4120EQ12]]THEN#31=3\n"),
                ElementsAre(HasSubstr("set only for #4120 = 11 or 12.")));
    EXPECT_THAT(told("IF[#4120NE12]GOTO5\n#31=3\nN5"), ElementsAre(HasSubstr("set only for #4120 = 12.")));
}

TEST(UninitialisedLocal, IsFoundBehindAReadToWhichNoPathLeads) {
    const std::string first = "O1\nIF[#501EQ1]GOTO5\n#10=1\nN5IF[#501EQ1]GOTO6\n#11=#10*2\nX#11\n";
    EXPECT_THAT(lines_raised("MAC209", first + "N6Y#10\nM30\n"), ElementsAre(7));
    EXPECT_THAT(lines_raised("MAC209", first + "N6M30\n"), IsEmpty());
}

TEST(UninitialisedLocal, PassedOnIsNotUsed) {
    EXPECT_THAT(lines_raised("MAC209", "O9001\nG0 Y#25\nG65 P9853 E#14\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC209", "O9001\nG0 Y#25\n#148=#16\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC209", "O9001\nG0 Y#25\n#31=#16\nG65 P9853 E#31\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC209", "O9001\nG0 Y#25\n#31=#16*2\n#31=5.\nG0 X#31\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC209", "O9001\nG0 Y#25\n#31=#16\n#30=#31\nG0 X#30\nM99\n"), ElementsAre(3));
    EXPECT_THAT(lines_raised("MAC209", "O9001\nG0 Y#25\n#148=#16*2\nM99\n"), ElementsAre(3));
}

TEST(UninitialisedLocal, PassedOnByAProgramThatNobodyCallsIsTold) {
    EXPECT_THAT(lines_raised("MAC209", "O1\n#26=-.2\nG65 P9811 Z#18\nM30\n"), ElementsAre(3));
    EXPECT_THAT(lines_raised("MAC209", "O1\n#18=-.2\nG65 P9811 Z#18\nM30\n"), IsEmpty());
}

TEST(UninitialisedLocal, AWordThatIsIgnoredOnTheWayToAnAlarmDoesNoHarm) {
    const std::string begin = "O9001\nIF[#1EQ#0]GOTO9\n#31=#5003\nG0 Z#1\nG0 Z#31\nM99\n";
    EXPECT_THAT(lines_raised("MAC209", begin + "N9 G0 Z#31\n#3000=91(INPUT)\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC209", begin + "N9 G0 Z#31\nM99\n"), ElementsAre(7));
    // What is calculated on the way there does not matter either where the word does not.
    EXPECT_THAT(lines_raised("MAC209", begin + "N9 G0 Z#31\nIF[#1NE#0]GOTO8\n#3000=91\nN8 M99\n"), IsEmpty());
}

TEST(UninitialisedLocal, AComputedJumpGoesWhereItsNumberLeads) {
    const std::string text =
        "O9001\n#32=50\nN50 IF[#24LE#7]GOTO56\n#32=56\nGOTO63\nN56 IF[#1EQ#0]GOTO58\n#29=#17\nGOTO64\n"
        "N58 GOTO#32\nN63 GOTO#32\nN64 G0 X#29\nM99\n";
    EXPECT_THAT(lines_raised("MAC209", text), IsEmpty());
}

TEST(UninitialisedLocal, AnAlarmOfACalledProgramIsNotForgottenByMovesAfterAnUnknownOne) {
    const std::string text =
        "O9001\nG65 P9723\nIF[#26NE#0]GOTO1\n#149=260\nG0 X5.\nG65 P9700\nGOTO2\nN1 #31=#26\n"
        "N2 G0 Z#31\nM99\nO9700\nGOTO#149\nN260 #3000=91(Z MISSING)\nN500 M99\n";
    EXPECT_THAT(lines_raised("MAC209", text), IsEmpty());
}

TEST(UninitialisedLocal, ALetterThatIsUsedOnlyWhereItIsLeftOutIsTold) {
    EXPECT_THAT(lines_raised("MAC209", "O9002\nIF[#24NE#0]GOTO9\nG0 X#24 Y#25\nM99\nN9 #3000=1\n"),
                ElementsAre(3));
    EXPECT_THAT(lines_raised("MAC209", "O9002\nIF[#24EQ#0]GOTO9\nG0 X#24 Y#25\nM99\nN9 #3000=1\n"),
                IsEmpty());
    // Counted from there, or passed on: a custom.
    EXPECT_THAT(lines_raised("MAC209", "O9002\nIF[#24NE#0]GOTO9\n#24=#24+1\nN9 G0 X#24\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC209", "O9002\nIF[#24NE#0]GOTO9\nG65 P9003 X#24\nN9 M99\n"), IsEmpty());
}

TEST(UninitialisedLocal, ALetterThatIsComparedOnlyWhereItIsLeftOutIsTold) {
    EXPECT_THAT(
        lines_raised("MAC209", "O9002\nG0 X#24\nIF[#21NE#0]GOTO9\nIF[#5063LT#21]GOTO9\nG0 X0\nN9 M99\n"),
        ElementsAre(4));
    EXPECT_THAT(
        lines_raised("MAC209", "O9002\nG0 X#24\nIF[#21EQ#0]GOTO9\nIF[#5063LT#21]GOTO9\nG0 X0\nN9 M99\n"),
        IsEmpty());
    // That the condition is therefore always true, or never, is the same cause.
    for (const std::string test : {"IF[#21LT3]GOTO9", "IF[#21GT3]GOTO9", "IF[ABS[#143]GE#21]GOTO9"}) {
        const std::string text = "O9002\nG0 X#24\nIF[#21NE#0]GOTO9\n" + test + "\nG0 X0\nN9 M99\n";
        EXPECT_THAT(lines_raised("MAC209", text), ElementsAre(4)) << test;
        EXPECT_THAT(lines_raised("MAC718", text), IsEmpty()) << test;
    }
    // A flag that another path sets is asked for, not used.
    EXPECT_THAT(
        lines_raised("MAC209", "O9002\nIF[#21NE#0]GOTO9\nIF[#21LT3]GOTO8\nG0 X0\nN8\n#21=1\nN9 M99\n"),
        IsEmpty());
}

TEST(UninitialisedLocal, ThatOnlyVacantComesThroughATestIsKnownOfEveryVariable) {
    // Locals that a subprogram shares with its caller, and what a store through an index may have changed.
    EXPECT_THAT(lines_raised("MAC209", "O1\nM98 P2\nM30\nO2\nIF[#21NE#0]GOTO9\nG0 X[#21+1.]\nN9 M99\n"),
                ElementsAre(6));
    EXPECT_THAT(lines_raised("MAC209", "O9002\n#[#3]=0\nIF[#21NE#0]GOTO9\nG0 X[#21+1.]\nN9 M99\n"),
                ElementsAre(4));
    EXPECT_THAT(lines_raised("MAC209", "O9002\nIF[#500NE#0]GOTO9\nG0 X[#500+1.]\nN9 M99\n"), ElementsAre(3));
    // Set vacant by the program itself, or found vacant and then set.
    EXPECT_THAT(lines_raised("MAC209", "O9002\n#500=#0\nG0 X#500\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC209", "O9002\nIF[#500NE#0]GOTO9\n#500=2.\nG0 X[#500+1.]\nN9 M99\n"),
                IsEmpty());
}

TEST(UninitialisedLocal, ALetterThatIsPassedOnWhereEveryValueIsRefusedIsTold) {
    const auto passed_on = [](std::string_view test, std::string_view refused) {
        return "O9002\nG0 X#24\n" + std::string(test) + "\nG65 P9003 D#7\nM99\nN9 " + std::string(refused) +
               "\n";
    };
    EXPECT_THAT(lines_raised("MAC209", passed_on("IF[#7NE#0]GOTO9", "#3000=1(D)")), ElementsAre(4));
    EXPECT_THAT(lines_raised("MAC209", passed_on("IF[#7EQ#0]GOTO9", "#3000=1(D)")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC209", passed_on("IF[#7NE#0]GOTO9", "M99")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC209", passed_on("IF[#8NE#0]GOTO9", "#3000=1(E)")), IsEmpty());
    // Not every value is refused.
    EXPECT_THAT(lines_raised("MAC209", passed_on("IF[#7GT5.]THEN#3000=1(D)\nIF[#7NE#0]GOTO9", "M99")),
                IsEmpty());
    EXPECT_THAT(lines_raised("MAC209", "O9002\nIF[#7EQ#0]GOTO1\n#3000=1\nN1 G65 P9003 D#7\nM99\n"),
                ElementsAre(4));
}

TEST(UninitialisedLocal, ManyTestsOfOneValueAreNotTooMany) {
    const std::string text =
        "O9001\nIF[#4012EQ54]GOTO2\nIF[#4012EQ55]GOTO2\nIF[#4012EQ56]GOTO2\nIF[#4012EQ57]GOTO2\nGOTO9\n"
        "N2\nIF[#4012EQ54]THEN#500=1\nIF[#4012EQ55]THEN#501=1\nIF[#4012LE55]THEN#31=#24\n"
        "G1 X[#21-#31] F#9\nN9 M99\n";
    EXPECT_THAT(lines_raised("MAC209", text), ElementsAre(11));
}

TEST(ZeroTest, MattersWhereVacantIsUsedAfterwards) {
    // The variable is asked for vacancy before it is used, or set, or not used at all.
    EXPECT_THAT(lines_raised("MAC220", "O9001\nIF[#1NE0]GOTO60\n#3000=1\nN60\nG0X1.\nG0Y1.\nG0Z1.\nIF[#1EQ#0]"
                                       "GOTO70\nG0X[#1+1]\nN70M99\n"),
                IsEmpty());
    EXPECT_THAT(lines_raised("MAC220", "O9001\nIF[#1EQ0]GOTO9\n#1=5.\n#33=#1+1\nN9M99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC220", "O9001\nIF[#1EQ0]GOTO9\nG0X5.\nN9M99\n"), IsEmpty());
    // As an operand, also of a copy, as a word, an argument, an index or for other programs.
    const auto behind = [](const std::string& block) {
        return lines_raised("MAC220", "O9001\nIF[#1EQ0]GOTO9\n" + block + "\nN9M99\n");
    };
    EXPECT_THAT(behind("#33=#1\nG0X[#33+1]"), ElementsAre(2));
    EXPECT_THAT(behind("G0Z5.X#1"), ElementsAre(2));
    EXPECT_THAT(behind("G65P9002A#1"), ElementsAre(2));
    EXPECT_THAT(behind("#501=#[#1+500]"), ElementsAre(2));
    EXPECT_THAT(behind("#500=#1"), ElementsAre(2));
    EXPECT_THAT(behind("IF[#1GT5]GOTO9\nG0Z5."), ElementsAre(2));
    EXPECT_THAT(behind("#33=#1"), IsEmpty());
}

TEST(ZeroTest, IsSilentWhereVacantAndZeroLeadToTheSame) {
    EXPECT_THAT(lines_raised("MAC220", "O9001\nIF[#7EQ0]GOTO9\nM#7\nN9M99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC220", "O9001\n#2=5\nIF[#1NE0]THEN#2=#2+#1\nG0X#2\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC220", "O9001\n#2=5\nIF[#1NE0]THEN#2=1+#1\nG0X#2\nM99\n"), ElementsAre(3));
    // What is vacant goes the same way by the next test, and does something else than 0 later.
    EXPECT_THAT(lines_raised("MAC220", "O9001\nIF[#5EQ0]GOTO5\nIF[#5EQ#0]GOTO5\nG1X5.\nN5G0X#5\nM99\n"),
                IsEmpty());
    EXPECT_THAT(lines_raised("MAC220", "O9001\nIF[#5EQ0]GOTO5\nIF[#6EQ#0]GOTO5\nG1X5.\nN5G0X#5\nM99\n"),
                ElementsAre(2));
    // The check behind it refuses both.
    const std::string refused = "\nIF[#1LT0.1]GOTO8\nG0X#1\nM99\nN8#3000=1\n";
    EXPECT_THAT(lines_raised("MAC220", "O9001\nIF[#1EQ0]GOTO8" + refused), IsEmpty());
    EXPECT_THAT(lines_raised("MAC220", "O9001\nIF[#1EQ0]GOTO8\nIF[#1LT-5]GOTO8\nG0X#1\nM99\nN8#3000=1\n"),
                ElementsAre(2));
    // A choice among numbers that refuses what is missing.
    EXPECT_THAT(lines_raised("MAC220", "O9001\nIF[#2EQ0]GOTO5\nIF[#2EQ1]GOTO5\n#3000=1\nN5G0X5.\nM99\n"),
                IsEmpty());
}

TEST(ZeroTest, ThatKeepsADefaultFromWhatIsMissingMattersThoughTheMissingIsRefused) {
    EXPECT_THAT(lines_raised("MAC220", "O9001\nIF[#19NE0]GOTO5\n#19=930\nN5IF[#19LE200]GOTO8\nS#19\nM99\n"
                                       "N8#3000=1\n"),
                ElementsAre(2));
}

TEST(ZeroTest, OfALetterThatMayBeLeftOutIsNoneWhereARangeRefusesIt) {
    EXPECT_THAT(lines_raised("MAC220", "O9001\nIF[#19EQ0]GOTO5\nIF[#19LT54]GOTO8\nS#19\nN5G0X5.\nM99\n"
                                       "N8#3000=1\n"),
                ElementsAre(2));
    // The checks of other letters let no run through.
    EXPECT_THAT(lines_raised("MAC220", "O9001\nIF[#8NE0]GOTO6\n#8=400.\nN6IF[#24NE12345.6]GOTO8\n"
                                       "IF[#25NE12345.7]GOTO8\nIF[#26NE[#24*#25+1.5]]GOTO8\nIF[#8LT10]GOTO8\n"
                                       "G1X5.F#8\nM99\nN8#3000=1\n"),
                ElementsAre(2));
    EXPECT_THAT(lines_raised("MAC220",
                             "O9001\nIF[#8NE0]GOTO6\n#8=0\nN6IF[#24NE12345.6]GOTO8\n"
                             "IF[#25NE12345.7]GOTO8\nIF[#26NE[#24*#25+1.5]]GOTO8\nIF[#8LT-10]GOTO8\n"
                             "G1X5.\nM99\nN8#3000=1\n"),
                IsEmpty());
    EXPECT_THAT(lines_raised("MAC220", "O9001\nIF[#8NE0]GOTO6\n#8=0\nN6IF[#8LT-10]GOTO8\nG0X[5.+#8]\nM99\n"
                                       "N8#3000=1\n"),
                IsEmpty());
}

TEST(ZeroTest, BesideAnotherTestForVacancyForgetsWhatItExpects) {
    const std::string later = "\nN4M8\nN5IF[#1EQ#0]GOTO9\nG0X#1\nN9M99\n";
    EXPECT_THAT(lines_raised("MAC220", "O9001\nIF[#1EQ0]GOTO5" + later), ElementsAre(2));
    EXPECT_THAT(messages_raised("MAC220", "O9001\nIF[#1EQ0]GOTO5" + later),
                ElementsAre(HasSubstr("Line 4 expects that it can be vacant")));
    // Only numbers are meant, and nothing is done with them.
    EXPECT_THAT(lines_raised("MAC220", "O9001\nIF[#1EQ0]GOTO5\nN4M8\nN5G0X5.\nM99\n"), IsEmpty());
    // What is missing is refused always.
    EXPECT_THAT(lines_raised("MAC220", "O9001\nIF[#1NE0]GOTO8\nIF[#1NE#0]GOTO5\nM8\nN5M99\nN8#3000=1\n"),
                ElementsAre(2));
}

TEST(ZeroTest, OfARowOfTestsForVacancyIsNoTestForAWrongZero) {
    const auto row = [](const std::string& first) {
        return lines_raised("MAC220", "O9001\n" + first +
                                          "\nIF[#2NE0]GOTO3\n#3000=1\nN3IF[#2EQ#0]GOTO9\nG0Y#2\n"
                                          "N9M99\n");
    };
    EXPECT_THAT(row("IF[#1NE#0]GOTO3"), ElementsAre(3));
    EXPECT_THAT(row("IF[#1NE#0]GOTO9"), IsEmpty());
    EXPECT_THAT(row("IF[#1NE5]GOTO3"), IsEmpty());
}

TEST(ZeroTest, OfALetterMattersBehindAProgramThatIsNotThere) {
    const auto behind = [](const std::string& before) {
        return lines_raised("MAC220",
                            "O9001\n" + before + "M98P9723\nIF[#25NE0]GOTO10\n#25=#2\nN10\nG0X0Y#25\nM99\n");
    };
    EXPECT_THAT(behind(""), ElementsAre(3));
    EXPECT_THAT(behind("#25=5\n"), IsEmpty());
    EXPECT_THAT(behind("IF[#25NE#0]GOTO2\n#25=5\nN2"), IsEmpty());
}

TEST(ZeroTest, FollowsTheVacantVariableThroughOtherTests) {
    // The variable is used on the next line, or where the test between them leads.
    const auto on = [](const std::string& between) {
        return lines_raised("MAC220", "O9001\nIF[#1EQ0]GOTO9\n" + between + "\nG0X[#1+1.]\nN8\nN9M99\n")
            .size();
    };
    const auto where_it_leads = [](const std::string& test) {
        return lines_raised("MAC220", "O9001\nIF[#1EQ0]GOTO9\n" + test + "\nM99\nN8G0X[#1+1.]\nN9M99\n")
            .size();
    };
    EXPECT_EQ(on("IF[#1EQ#0]GOTO8"), 0U);
    EXPECT_EQ(on("IF[#1NE5]GOTO8"), 0U);
    EXPECT_EQ(on("IF[5NE#1]GOTO8"), 0U);
    EXPECT_EQ(on("IF[#1GT5]GOTO8"), 1U);
    EXPECT_EQ(on("IF[#2EQ#0]GOTO8"), 1U); // of another variable
    EXPECT_EQ(where_it_leads("IF[#1NE#0]GOTO8"), 0U);
    EXPECT_EQ(where_it_leads("IF[#1NE5]GOTO8"), 1U);
    EXPECT_EQ(where_it_leads("IF[5NE#1]GOTO8"), 1U);
    EXPECT_EQ(where_it_leads("IF[#2EQ#0]GOTO8"), 1U);
    EXPECT_EQ(on("#1=3"), 0U);
    EXPECT_EQ(on("#2=3"), 1U);
    EXPECT_EQ(on("IF[#2EQ1]THEN#1=3"), 1U);
}

TEST(ZeroTest, OfAWordMattersWhereTheOtherSideIsAnAlarm) {
    EXPECT_THAT(lines_raised("MAC220", "O9001\nIF[#20EQ0]GOTO9\nS#20\nN9M99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC220", "O9001\nIF[#20EQ0]GOTO9\nS#20\nM99\nN9#3000=1\n"), ElementsAre(2));
    EXPECT_THAT(lines_raised("MAC220", "O9001\nIF[#20EQ0]THEN#3000=1\nS#20\nM99\n"), ElementsAre(2));
    EXPECT_THAT(lines_raised("MAC220", "O9001\nIF[#20NE0]GOTO1\n#3000=1\nN1S#20\nM99\n"), ElementsAre(2));
}

TEST(ZeroTest, MattersWhereABlockThatCannotBeReadNamesTheVariable) {
    const auto after = [](std::string_view block) {
        return "O9001\nIF[#4EQ0]THEN#3000=1\n" + std::string(block) + "\nG0X1.\nM99\n";
    };
    EXPECT_THAT(lines_raised("MAC220", after("#33=ABS(#26)+[1/#4]")), ElementsAre(2));
    EXPECT_THAT(messages_raised("MAC220", after("#33=ABS(#26)+[1/#4]")), ElementsAre(HasSubstr("line 3")));
    EXPECT_THAT(lines_raised("MAC220", after("#33=ABS(#26)+[1/#5]")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC220", after("#4 = ABS(#26)+[1/#5]")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC220", after("IF[#4EQ#0]]GOTO9")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC220", "O9001\nIF[#4EQ0]GOTO9\n#33=ABS(#26)+[1/#4]\nN9M99\n"),
                ElementsAre(2));
}

TEST(ZeroTest, ShowsTheCallThatLeavesTheArgumentOut) {
    const std::string macro = "O9001\nIF[#1EQ1]GOTO9\nIF[#6EQ0]GOTO9\nG0Z[#6*2]\nN9M99\n";
    EXPECT_THAT(path_raised("MAC220", "O1\nG65P9001K2.\nG65P9001A1.\nG65P9001A2.\nM30\n" + macro),
                ElementsAre(4, 8));
    EXPECT_THAT(path_raised("MAC220", "O1\nG65P9001A1.\nG65P9001K2.\nM30\n" + macro), ElementsAre(5, 7));
    EXPECT_THAT(path_raised("MAC220", "O1\nG65P9001A#500\nM30\n" + macro), ElementsAre(2, 6));
}

TEST(ZeroTest, OnAPathThatNobodyCanTakeIsNoDefect) {
    EXPECT_THAT(lines_raised("MAC220", "O9001\nIF[#1EQ1.]GOTO7\n#31=2.\nN7G0X0\nIF[#1EQ1.]GOTO8\n"
                                       "IF[#31EQ0]GOTO8\nG0X[#31*2]\nN8M99\n"),
                IsEmpty());
}

TEST(TestOfAnOverwrittenVariable, TellsWhereTheValueFromTheCallIs) {
    EXPECT_THAT(messages_raised("MAC228", "O9001\n#33=#26\n#26=#5003\nIF[#26EQ#0]GOTO9\nG0Z#33\nN9M99\n"),
                ElementsAre(AllOf(HasSubstr("#26 (Z)"), HasSubstr("line 3"), HasSubstr("is in #33"))));
    EXPECT_THAT(messages_raised("MAC228", "O9001\n#26=#5003\nIF[#26EQ#0]GOTO9\nG0Z#26\nN9M99\n"),
                ElementsAre(HasSubstr("before that")));
}

TEST(TestOfAnOverwrittenVariable, IsNoneOfAVariableThatNoTableKnows) {
    EXPECT_THAT(lines_raised("MAC228", "O9001\n#24=#900018\nIF[#24EQ#0]GOTO9\nG0X#24\nN9M99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC228", "O9001\n#24=#9123\nIF[#24EQ#0]GOTO9\nG0X#24\nN9M99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC228", "O9001\n#24=#4120\nIF[#24EQ#0]GOTO9\nG0X#24\nN9M99\n"),
                ElementsAre(3));
}

TEST(MissingArgumentValidation, IsToldOfABoundThatNothingElseIsHeldAgainst) {
    const std::string loop = "#33=0\nWHILE[#33LT#3]DO1\n#33=#33+1.\nG1X#33\nEND1\nM99\n";
    EXPECT_THAT(judged("MAC604", "O9001\n" + loop), ElementsAre("note 3"));
    // A search through 24 pockets ends there, whatever is looked for.
    EXPECT_THAT(judged("MAC604", "O9001\n#1=1\nWHILE[#1LE24]DO1\nIF[#1EQ#20]GOTO2\n#1=#1+1\nEND1\n"
                                 "#3000=1\nN2#149=#[600+#1]\nM99\n"),
                IsEmpty());
    EXPECT_THAT(judged("MAC604", "O9001\n#1=1\nWHILE[#1NE24]DO1\nIF[#1GE#20]GOTO2\n#1=#1+2\nEND1\nN2M99\n"),
                ElementsAre("note 4"));
    EXPECT_THAT(judged("MAC604", "O9001\nIF[#3GT99]THEN#3000=1\n" + loop), IsEmpty());
    EXPECT_THAT(judged("MAC604", "O9001\nIF[#3EQ#0]THEN#3=9\n" + loop), IsEmpty());
    EXPECT_THAT(judged("MAC604", "O9001\nIF[#4EQ#0]THEN#3000=1\n" + loop), ElementsAre("note 4"));
    // The counter is no check, wherever it is held against the argument; a second counter has nothing to add.
    EXPECT_THAT(judged("MAC604", "O9001\n#33=0\nWHILE[#3GT#33]DO1\nG1X#33\n#33=#33+1.\nEND1\nM99\n"),
                ElementsAre("note 3"));
    EXPECT_THAT(judged("MAC604", "O9001\n#33=0\nN1G1X#33\n#33=#33+1.\nIF[#33LT#3]GOTO1\nM99\n"),
                ElementsAre("note 5"));
    EXPECT_THAT(
        judged("MAC604",
               "O9001\n#33=0\nWHILE[#33LT#3]DO1\n#33=#33+1.\nIF[#33GT#3]THEN#33=#3\nG1X#33\nEND1\nM99\n"),
        ElementsAre("note 3"));
    // Another bound than the argument as it was passed; a program that is no macro; all calls pass it.
    EXPECT_THAT(judged("MAC604", "O9001\n#3=5.\n" + loop), IsEmpty());
    EXPECT_THAT(judged("MAC604", "O1\nG65P9001C5.\nM30\nO9001\n" + loop), IsEmpty());
    EXPECT_THAT(judged("MAC604", "O1\nG65P9001C5.\nG65P9001\nM30\nO9001\n" + loop), ElementsAre("note 7"));
}

TEST(OffsetNumber, ThatNothingChecksIsANote) {
    EXPECT_THAT(judged("MAC225", "O9001\n#30=#[13000+#7]\nX#30\nM99\n"), ElementsAre("note 2"));
    EXPECT_THAT(judged("MAC225", "O9001\n#[2000+#7]=1.\nM99\n"), ElementsAre("note 2"));
    EXPECT_THAT(judged("MAC225", "O9001\n#30=#[100+#7]\nX#30\nM99\n"), IsEmpty()); // no offset
    // Nor is a number that no integer holds; a sanitizer would say so.
    const std::string huge(99, '9');
    EXPECT_THAT(judged("MAC225", "O9001\n#[" + huge + "+#7]=1.\nM99\n"), IsEmpty());
    EXPECT_THAT(judged("MAC225", "O9001\nIF[#7GT99]GOTO9\n#30=#[13000+#7]\nX#30\nN9M99\n"), IsEmpty());
    EXPECT_THAT(judged("MAC225", "O9001\nIF[#7EQ#0]THEN#7=1\n#30=#[13000+#7]\nX#30\nM99\n"), IsEmpty());
}

TEST(OffsetNumber, IsAWarningWhereACallLeavesItOutOrOtherArgumentsAreChecked) {
    const std::string macro = "O9001\nIF[#2EQ1]GOTO1\nN1#30=#[13000+#7]\nX#30\nM99\n";
    EXPECT_THAT(judged("MAC225", "O1\nG65P9001B1.D1\nG65P9001B1.\nM30\n" + macro), ElementsAre("warning 7"));
    EXPECT_THAT(judged("MAC225", "O1\nG65P9001B1.D1\nM30\n" + macro), IsEmpty());
    EXPECT_THAT(judged("MAC225", "O9001\nIF[#2EQ#0]THEN#3000=1\n#30=#[13000+#7]\nX#30\nM99\n"),
                ElementsAre("warning 3"));
}

TEST(CallersLocals, ThatNoCallerSetsAreVacantOnAPath) {
    const std::string called = "O9001\nIF[#500EQ1]GOTO2\n#1=1\nN2G#1X1.\nM99\n";
    EXPECT_THAT(messages_raised("MAC209", "O1\nM98P9001\nM30\n" + called),
                ElementsAre(AllOf(HasSubstr("#1"), HasSubstr("nor do the programs"))));
    // Set before the call, or perhaps: in the caller, by another call of it, further up, through an index.
    for (const std::string caller :
         {"O1\n#1=2\nM98P9001\nM30\n", "O1\nIF[#501EQ1]THEN#1=2\nM98P9001\nM30\n",
          "O1\nM98P9002\nM98P9001\nM30\nO9002\n#1=3\nM99\n",
          "O1\nM98P9002\nM98P9001\nM30\nO9002\nM98P9004\nM99\nO9004\n#1=3\nM99\n",
          "O1\n#1=2\nM98P9002\nM30\nO9002\nM98P9001\nM99\n", "O1\n#[#501]=2\nM98P9001\nM30\n",
          "O1\nM98P#501\nM98P9001\nM30\n", "O1\nM98P9003\nM98P9001\nM30\n", "O9002\nM98P9001\nM99\n",
          "O1\nG65P9002A1\nM30\nO9002\nM98P9001\nM99\n", "O1\nM98P9001\nG65P9001A1\nM30\n"})
        EXPECT_THAT(messages_raised("MAC209", caller + called), IsEmpty()) << caller;
    // What cannot be #1; the program itself, which has not run before.
    for (const std::string caller :
         {"O1\n#[500+#501]=2\n#2=1\n#101=1\nM98P9001\nM30\n",
          "O1\nM98P9002\nM30\nO9002\n#2=1\nM98P9001\nM99\n",
          "O1\nG65P9002A1\nM98P9001\nM30\nO9002\n#1=3\nM99\n", "O1\nM98P9001\nM98P9001\nM30\n"})
        EXPECT_THAT(messages_raised("MAC209", caller + called), SizeIs(1)) << caller;
}

TEST(CallersLocals, DecideNothingAsOthersMayCallTheProgram) {
    const std::string program = "O1\nM98P9001\nM30\nO9001\nIF[#1EQ#0]GOTO2\nG0X#1\nN2M99\n";
    for (const std::string rule : {"MAC209", "MAC228", "MAC460", "MAC718"})
        EXPECT_THAT(messages_raised(rule, program), IsEmpty()) << rule;
}

TEST(CallersLocals, OfAnUnknownCallerMayBeWhatNothingSets) {
    EXPECT_THAT(judged("MAC209", "O9001\nG0Z#31\nM99\n"), ElementsAre("note 2"));
    EXPECT_THAT(judged("MAC209", "O9001\nIF[#500EQ1]THEN#31=1\nG0Z#31\nM99\n"), IsEmpty());
    EXPECT_THAT(judged("MAC209", "O9001\nIF[#31EQ#0]THEN#3000=1\nG0Z#31\nM99\n"), IsEmpty());
    // A program with arguments has its own; nobody calls a main program.
    EXPECT_THAT(judged("MAC209", "O9001\nG0X#24Z#31\nM99\n"), ElementsAre("warning 2"));
    EXPECT_THAT(judged("MAC209", "O1\nG0Z#31\nM30\n"), ElementsAre("warning 2"));
}

TEST(UninitialisedLocal, MayBeASpeedForSomeCases) {
    EXPECT_THAT(lines_raised("MAC209", "O9001\nIF[#1EQ1]THEN#10=800\nS[#10]\nG1X#24\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC209", "O9001\nIF[#1EQ1]THEN#10=800\nS[#10]M3\nG1X#24\nM99\n"),
                ElementsAre(3));
    EXPECT_THAT(lines_raised("MAC209", "O9001\nIF[#1EQ1]THEN#10=800\nZ#10\nG1X#24\nM99\n"), ElementsAre(3));
    EXPECT_THAT(lines_raised("MAC209", "O9001\nIF[#1EQ1]GOTO2\n#10=800\nN2S#10\nG1X#24\nM99\n"),
                ElementsAre(4));
    EXPECT_THAT(lines_raised("MAC209", "O9001\nS[#10]\nG1X#24\nM99\n"), ElementsAre(2));
}

} // namespace
} // namespace maclint
