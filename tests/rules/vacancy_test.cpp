//! Rules about vacant variables: MAC209, MAC220, MAC221, MAC222, MAC228.
#include "tests/rules/raised.hpp"

#include <gmock/gmock.h>

namespace maclint {
namespace {

using test::lines_raised;
using test::messages_raised;
using test::path_raised;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(UninitialisedLocal, IsReportedOnceWithTheProgramAsItsOrigin) {
    EXPECT_THAT(lines_raised("MAC209", "O1\nG0 X#5\nG0 Y#5\nM30\n"), ElementsAre(2));
    EXPECT_THAT(path_raised("MAC209", "O1\nG0 X#5\nM30\n"), ElementsAre(1, 2));
}

TEST(UninitialisedLocal, IsNotAnArgumentLetterOfAProgramThatIsCalled) {
    EXPECT_THAT(lines_raised("MAC209", "O9001\nG0 X#24\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC209", "O9001\nG0 X#24 Y#10\nM99\n"), ElementsAre(2));
}

TEST(UninitialisedLocal, IsNoneWhenAProgramTakesASeriesOfIJAndK) {
    const std::string series = "G0 X#4 Y#5 Z#6\nX#7 Y#8 Z#9\nX#10 Y#11 Z#12\nX#13 Y#14 Z#15\n";
    EXPECT_THAT(lines_raised("MAC209", "O9001\n" + series + "M99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC209", "O9001\n" + series + "X#33\nM99\n"), ElementsAre(6));
    EXPECT_THAT(lines_raised("MAC209", "O9001\nG0 X#10 Y#11 Z#12\nM99\n"), ElementsAre(2, 2));
    EXPECT_THAT(messages_raised("MAC209", "O9001\nG0 X#24 Y#10\nM99\n"),
                ElementsAre(HasSubstr("unless I, J and K are repeated")));
}

TEST(UninitialisedLocal, MayBeSetByTheCallerOfASubprogram) {
    EXPECT_THAT(lines_raised("MAC209", "O1\n#10=5\nM98 P2\nM30\nO2\nG0 X#10 Y#24\nM99\n"), IsEmpty());
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

TEST(UninitialisedLocal, SetOnOneWayOnlyIsToldWithTheOtherWay) {
    const std::string text = "O1\nIF[#1004EQ1]GOTO3\n#31=5\nN3 G0 X#31\nM30\n";
    EXPECT_THAT(messages_raised("MAC209", text),
                ElementsAre(HasSubstr("when the path that sets it is not taken")));
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
    EXPECT_THAT(lines_raised("MAC220", "O9001\nIF[#6EQ0]GOTO9\nG0 Z#6\nN9 M99\n"), ElementsAre(2));
    EXPECT_THAT(messages_raised("MAC220", "O9001\nIF[0 NE #6]GOTO9\nG0 Z#6\nN9 M99\n"),
                ElementsAre(HasSubstr("is also true when #6 is vacant")));
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
}

TEST(UninitialisedLocal, ATestOfAnotherVariableOnTheWayIsHeeded) {
    // #31 and #32 are set under the same tests: where #31 is not vacant, #32 is not either.
    const std::string program = "O9001\nIF[#1EQ1]GOTO1\nIF[#1EQ2]GOTO2\nGOTO3\n"
                                "N1 #32=1\n#31=1\nGOTO3\nN2 #32=2\n#31=2\nN3\n";
    EXPECT_THAT(lines_raised("MAC209", program + "IF[#31EQ#0]GOTO9\nG0 X#32\nN9 M99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC209", program + "G0 X#32\nN9 M99\n"), ElementsAre(11));
}

TEST(UninitialisedLocal, AnIndexMadeOfAVacantVariableIsToldThere) {
    EXPECT_THAT(lines_raised("MAC209", "O1\nG0 X#[#31+10]\nM30\n"), ElementsAre(2));
    EXPECT_THAT(messages_raised("MAC209", "O1\nG0 X#[#31+10]\nM30\n"),
                ElementsAre(::testing::HasSubstr("'#31'")));
}

} // namespace
} // namespace maclint
