//! Calls that end in an alarm, and programs that run into their own: MAC461, MAC470.
#include "tests/rules/raised.hpp"
#include "tests/support/analysed.hpp"

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

/// A macro that asks for A, and one that also lacks the M99 in front of its alarm.
const std::string asks_for_a = "O2\nIF[#1EQ#0]GOTO99\nG1X#1Y#2F200.\nM99\nN99#3000=101(A MISSING)\n";
const std::string runs_in = "O2\nIF[#1EQ#0]GOTO99\nG1X#1F200.\nN99#3000=101(A MISSING)\nM99\n";
/// One that is there to stop.
const std::string stops = "O3\nGOTO#149\nN260#3000=91(Z MISSING)\nN261#3000=92(NO CONTACT)\nM99\n";

TEST(CallEndsInAlarm, IsToldOfACallThatLeavesOutWhatItsProgramAsksFor) {
    EXPECT_THAT(
        messages_raised("MAC470", "O1\nG65P2B5.\nM30\n" + asks_for_a),
        ElementsAre("Call ends in an alarm: 'G65P2B5.' leaves #1 (A) vacant, and O2 then always comes "
                    "to '#3000=101(A MISSING)' on line 8. Pass it."));
    EXPECT_THAT(lines_raised("MAC470", "O1\nG65P2A5.\nG65P2A#500\nM30\n" + asks_for_a), IsEmpty());
    EXPECT_THAT(lines_raised("MAC470", "O1\nG65P2A#0\nM30\n" + asks_for_a), ElementsAre(2));
    // Of what an argument may be nothing is known.
    EXPECT_THAT(lines_raised("MAC470", "O1\nG65P2A[#500+1.]\nM30\n" + asks_for_a), IsEmpty());
}

TEST(CallEndsInAlarm, HoldsForEveryKindOfCall) {
    EXPECT_THAT(lines_raised("MAC470", "O1\nM98P2\nM30\n" + asks_for_a), ElementsAre(2));
    EXPECT_THAT(lines_raised("MAC470", "O1\n#1=5.\nM98P2\nM30\n" + asks_for_a), IsEmpty());
    EXPECT_THAT(lines_raised("MAC470", "O1\nG66P2B5.\nG0X1.\nX2.\nG67\nM30\n" + asks_for_a), ElementsAre(2));
    EXPECT_THAT(lines_raised("MAC470", "O1\nG66P2A5.\nG0X1.\nG67\nM30\n" + asks_for_a), IsEmpty());
    EXPECT_THAT(lines_raised("MAC470", "O1\nG66P2B5.\nM5\nG67\nM30\n" + asks_for_a),
                IsEmpty()); // nothing moves
    EXPECT_THAT(lines_raised("MAC470", "O1\nG65P2L0B5.\nM30\n" + asks_for_a).size(), 1U);
}

TEST(CallEndsInAlarm, IsToldBehindATestWhereTheProgramWorks) {
    const std::string tested = "O1\nIF[#500EQ1]GOTO8\nG65P2B5.\nG0X9.\nN8M30\n";
    EXPECT_THAT(lines_raised("MAC470", tested + asks_for_a), ElementsAre(3));
    EXPECT_THAT(
        messages_raised("MAC470", tested + runs_in),
        ElementsAre("Call ends in an alarm: O2 runs into '#3000=101(A MISSING)' on line 9 on every path, "
                    "whatever is passed to it. End O2 before that, with M99 or a GOTO."));
}

TEST(CallEndsInAlarm, IsSilentOfCallsThatAreMadeToStop) {
    EXPECT_THAT(
        lines_raised("MAC470", "O1\nIF[#26NE#0]GOTO1\n#149=260\nG65P3\nGOTO2\nN1#31=#26\nN2M99\n" + stops),
        IsEmpty());
    EXPECT_THAT(lines_raised("MAC470",
                             "O1\nIF[#500EQ1]GOTO9\nG0X1.\nM30\nN9M98P3\nM30\nO3\nM5\n#3000=5(STOP)\nM99\n"),
                IsEmpty());
    // Parked first, and asked for what it was told.
    const std::string parks = "O3\nG53G0Z0\nM5\n#3000=5(STOP)\nM99\n";
    EXPECT_THAT(lines_raised("MAC470", "O1\nIF[#500EQ1]GOTO9\nG65P3\nN9G0X1.\nM30\n" + parks), IsEmpty());
    const std::string tells = "O3\nIF[#1EQ#0]GOTO9\n#3006=1(LOOK)\nM99\nN9#3000=5(NO NUMBER)\n";
    EXPECT_THAT(lines_raised("MAC470", "O1\nIF[#500EQ1]GOTO9\nG65P3B1.\nN9G0X1.\nM30\n" + tells), IsEmpty());
}

TEST(CallEndsInAlarm, IsToldWhereEveryPathComesByEvenOfAProgramThatOnlyStops) {
    EXPECT_THAT(
        messages_raised("MAC470", "O1\nM98P3\nG0X1.\nM30\nO3\n#1=5.\nN99#3000=101(STOP)\nM99\n"),
        ElementsAre("Call ends in an alarm: O3 comes to '#3000=101(STOP)' on line 7, whatever is passed "
                    "to it. Delete the call, or correct O3."));
}

TEST(CallEndsInAlarm, IsToldBehindATestWhereWorkStandsBehindTheCall) {
    EXPECT_THAT(lines_raised("MAC470", "O1\nIF[#500EQ1]GOTO5\nM98P3\nG0X1.\nN5M30\nO3\n#3000=1(STOP)\nM99\n"),
                ElementsAre(3));
}

TEST(CallEndsInAlarm, NamesTheAlarmOfTheProgramThatIsCalledForIt) {
    EXPECT_THAT(messages_raised("MAC470", "O1\nG65P2B5.\nM30\n"
                                          "O2\nIF[#1EQ#0]GOTO99\nG1X#1F200.\nM99\nN99G65P3\n"
                                          "O3\n#3000=7(NO A)\n"),
                ElementsAre(AllOf(HasSubstr("'G65P2B5.' leaves #1 (A) vacant"),
                                  HasSubstr("O3 then always comes to '#3000=7(NO A)' on line 10"))));
}

/// Numbers are not followed: which of two alarms it is nobody says.
TEST(CallEndsInAlarm, NamesOneOfSeveralAsSuch) {
    EXPECT_THAT(messages_raised("MAC470", "O1\nG65P2A1.\nG0X1.\nM30\n"
                                          "O2\nG0X5.\nIF[#1EQ1]GOTO5\n#3000=2(A NOT 1)\nN5#3000=1(A IS 1)\n"),
                ElementsAre(HasSubstr("O2 comes to an alarm, as '#3000=2(A NOT 1)' on line 8, whatever")));
}

TEST(CallEndsInAlarm, NamesTheTestThatDecidesNotAnEarlierOne) {
    EXPECT_THAT(messages_raised("MAC470", "O1\nG65P2X5.\nM30\n"
                                          "O2\nIF[#24LT0]GOTO99\nIF[#26EQ#0]GOTO98\nG0X#24Z#26\nM99\n"
                                          "N98#3000=98(Z MISSING)\nN99#3000=99(X NEGATIVE)\n"),
                ElementsAre(AllOf(HasSubstr("#26 (Z) vacant"), HasSubstr("#3000=98(Z MISSING)"))));
    // What has a value of its own when it is left out is no reason.
    EXPECT_THAT(messages_raised("MAC470", "O1\nG65P2X5.\nM30\n"
                                          "O2\nIF[#9EQ#0]THEN#9=100.\nIF[#26EQ#0]GOTO98\nG0X#24Z#26F#9\nM99\n"
                                          "N98#3000=98(Z MISSING)\n"),
                ElementsAre(HasSubstr("#26 (Z) vacant")));
}

TEST(CallEndsInAlarm, TellsOfLettersOutOfOrder) {
    const std::string asks_for_i = "O2\nIF[#4EQ#0]GOTO99\nG1X#4Y#6F200.\nM99\nN99#3000=1(I MISSING)\n";
    EXPECT_THAT(messages_raised("MAC470", "O1\nG65P2K5.I1.\nM30\n" + asks_for_i),
                ElementsAre(HasSubstr("of I, J and K in 'G65P2K5.I1.' one stands behind a later one")));
    EXPECT_THAT(lines_raised("MAC470", "O1\nG65P2I1.K5.\nM30\n" + asks_for_i), IsEmpty());
}

TEST(CallEndsInAlarm, IsOneFindingForCallsThatAreAlike) {
    EXPECT_THAT(lines_raised("MAC470", "O1\nG65P2B1.\nG65P2B2.\nM30\n" + asks_for_a), ElementsAre(2, 3));
    EXPECT_THAT(judged("MAC470", "O1\nG65P2B1.\nM30\n" + asks_for_a), ElementsAre("error 2"));
}

TEST(CallEndsInAlarm, IsNoneWhereAnotherPathOfTheProgramEndsOrIsUnknown) {
    EXPECT_THAT(lines_raised("MAC470", "O1\nG65P2B5.\nM30\nO2\nIF[#1EQ#0]GOTO99\nM99\nN99 M30\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC470", "O1\nG65P2B5.\nM30\nO2\nIF[#1EQ#0]GOTO99\nM99\nN99IF[#500EQ1]GOTO98\n"
                                       "#3000=1\nN98M99\n"),
                IsEmpty());
    EXPECT_THAT(lines_raised("MAC470", "O1\nG65P2B5.\nM30\nO2\nIF[#100EQ#0]GOTO99\nG0X1.\nM99\nN99#3000=1\n"),
                IsEmpty());
    EXPECT_THAT(lines_raised("MAC470",
                             "O1\n#100=#0\nG65P2B5.\nM30\nO2\nIF[#100EQ#0]GOTO99\nG0X1.\nM99\nN99#3000=1\n"),
                ElementsAre(3));
}

TEST(FallthroughIntoAlarm, IsToldWhereNoCallIsKnown) {
    EXPECT_THAT(judged("MAC461", runs_in), ElementsAre("warning 4"));
    EXPECT_THAT(lines_raised("MAC461", "O1\nG65P2A1.\nM30\n" + runs_in), IsEmpty()); // MAC470 tells it there
    EXPECT_THAT(lines_raised("MAC461", asks_for_a), IsEmpty());
}

TEST(FallthroughIntoAlarm, IsNoneOfProgramsThatAreThereToStop) {
    EXPECT_THAT(lines_raised("MAC461", "O2\nG0Z100.\n#3000=1(STOP)\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC461", stops), IsEmpty());
    EXPECT_THAT(lines_raised("MAC461", "O2\nIF[#1EQ#0]GOTO9\n#3000=#1\nN9#3000=1(NO NUMBER)\nM99\n"),
                IsEmpty());
    // It is an alarm for a test, which passes it otherwise.
    EXPECT_THAT(lines_raised("MAC461", "O2\nG0X#1\nIF[#5061GT0]GOTO5\nN99#3000=1(NO CONTACT)\nN5M99\n"),
                IsEmpty());
}

} // namespace
} // namespace maclint
