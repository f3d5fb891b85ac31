//! Calls that are followed with their numbers: through a second call, to circles and to cycles.
#include "rules/rule.hpp"
#include "tests/rules/raised.hpp"
#include "tests/support/analysed.hpp"

#include <string>
#include <string_view>
#include <vector>

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

/// Takes D from 2 to 5, and needs it.
const std::string asks_for_d =
    "O3\nIF[#7EQ#0]GOTO99\nIF[#7LT2]GOTO99\nIF[#7GT5]GOTO99\nG0X#7\nM99\nN99#3000=101(D)\n";
const std::string passes_d_on = "O2\nG0X#24\nG65P3D#7\nG0Y#25\nM99\n";

TEST(NumbersPassedOn, AreToldAtTheFirstCall) {
    EXPECT_THAT(
        messages_raised("MAC470", "O1\nG65P2D7.X1.\nM30\n" + passes_d_on + asks_for_d),
        ElementsAre("Call ends in an alarm: for the value of #7 (D) at 'G65P2D7.X1.', O3 always comes "
                    "to '#3000=101(D)' on line 15. Give it another one."));
    EXPECT_THAT(lines_raised("MAC470", "O1\nG65P2D5.X1.\nM30\n" + passes_d_on + asks_for_d), IsEmpty());
    EXPECT_THAT(lines_raised("MAC470", "O1\nG65P2D#500X1.\nM30\n" + passes_d_on + asks_for_d), IsEmpty());
}

TEST(NumbersPassedOn, AreVacantLettersToo) {
    EXPECT_THAT(messages_raised("MAC470", "O1\nG65P2X1.\nM30\n" + passes_d_on + asks_for_d),
                ElementsAre(HasSubstr("leaves #7 (D) vacant, and O3 then always comes to")));
}

TEST(NumbersPassedOn, AreCalculatedWith) {
    const std::string halves = "O2\n#1=#7/2\nG65P3D#1\nM99\n";
    EXPECT_THAT(messages_raised("MAC470", "O1\nG65P2D12.\nM30\n" + halves + asks_for_d),
                ElementsAre(HasSubstr("for the values at 'G65P2D12.'")));
    EXPECT_THAT(lines_raised("MAC470", "O1\nG65P2D8.\nM30\n" + halves + asks_for_d), IsEmpty());
}

TEST(NumbersPassedOn, GoThroughCommonVariablesAndSubprograms) {
    const std::string shares = "O2\nM98P3\nM99\n";
    const std::string asks = "O3\nIF[#100GT5]GOTO99\nG0X#100\nM99\nN99#3000=101(#100)\n";
    EXPECT_THAT(lines_raised("MAC470", "O1\n#100=7\nG65P2\nM30\n" + shares + asks), ElementsAre(3));
    EXPECT_THAT(lines_raised("MAC470", "O1\n#100=5\nG65P2\nM30\n" + shares + asks), IsEmpty());
}

TEST(NumbersPassedOn, AreToldOnlyWhereEveryWayLeadsThere) {
    const auto told = [](const std::string& before) {
        return lines_raised("MAC470",
                            "O1\nG65P2D7.A1.\nM30\nO2\n" + before + "G65P3D#7\nN5G0Y#25\nM99\n" + asks_for_d);
    };
    EXPECT_THAT(told(""), ElementsAre(2));
    EXPECT_THAT(told("IF[#500EQ1]GOTO5\n"), IsEmpty()) << "nobody knows #500";
    EXPECT_THAT(told("IF[#1EQ1]GOTO5\n"), IsEmpty()) << "A leads around";
    EXPECT_THAT(told("IF[#1EQ2]GOTO5\n"), ElementsAre(2));
    EXPECT_THAT(told("IF[#500EQ1]THEN#3000=5(NO)\n"), ElementsAre(2)) << "it ends in an alarm either way";
}

TEST(NumbersPassedOn, LeaveToTheInnerCallWhatItBringsByItself) {
    EXPECT_THAT(lines_raised("MAC470", "O1\nG65P2D7.\nM30\nO2\nG65P3D9.\nG0X#7\nM99\n" + asks_for_d),
                ElementsAre(5));
}

TEST(NumbersPassedOn, AreNotToldBesideWhatTheInnerCallBringsByItself) {
    EXPECT_THAT(lines_raised("MAC470", "O1\nG65P2D7.X1.\nM30\nO2\nG65P3D9.X#24\nG0X#7\nM99\n" + asks_for_d),
                ElementsAre(5));
}

TEST(NumbersPassedOn, GoThroughThreeCalls) {
    const std::string more = "O4\nG65P2D#7\nM99\n";
    EXPECT_THAT(lines_raised("MAC470", "O1\nG65P4D7.\nM30\n" + more + passes_d_on + asks_for_d),
                ElementsAre(2));
}

/// A corner of radius R, by way and centre.
const std::string corner = "O2\nG17G91G1Y10.F100.\nG3X#24Y#25I0J#18\nG90\nM99\n";

TEST(CirclesOfCalls, AreHeldAgainstTheNumbers) {
    const auto told = messages_raised("MAC522", "O1\nG65P2X5.Y5.R3.\nM30\n" + corner);
    ASSERT_THAT(told, SizeIs(1));
    EXPECT_THAT(told.front(), HasSubstr("begins 3 from its centre and ends 5.3852 from it"));
    EXPECT_THAT(messages_raised("MAC522", "O1\nG65P2X5.Y5.R5.\nM30\n" + corner), IsEmpty());
    EXPECT_THAT(messages_raised("MAC522", "O1\nG65P2X5Y5R3\nM30\n" + corner), IsEmpty()) << "thousandths";
}

TEST(CirclesOfCalls, NameTheCall) {
    const auto findings =
        run_rules(*test::analyse_text("fanuc", "O1\nG65P2X5.Y5.R5.\nG65P2X5.Y5.R3.\nM30\n" + corner),
                  {{find_rule("MAC522")}}, 1);
    ASSERT_THAT(findings, SizeIs(1));
    ASSERT_THAT(findings.front().related, SizeIs(1));
    EXPECT_EQ(findings.front().related.front().text, "called with these numbers");
    EXPECT_EQ(findings.front().related.front().span.begin, 18U);
}

TEST(CirclesOfCalls, RestOnPositionsThatTheNumbersGive) {
    const std::string round = "O2\nG17G90G1X#24Y0F100.\nG2X50.Y20.I20.J0\nM99\n";
    EXPECT_THAT(lines_raised("MAC522", "O1\nG65P2X30.\nM30\n" + round), IsEmpty());
    EXPECT_THAT(lines_raised("MAC522", "O1\nG65P2X20.\nM30\n" + round), ElementsAre(6));
}

TEST(CirclesOfCalls, AreLookedAtWhereTheCallSurelyComes) {
    const auto told = [](const std::string& test) {
        return lines_raised("MAC522", "O1\nG65P2X5.Y5.R3.A1.\nM30\nO2\nG17G91G1Y10.F100.\n" + test +
                                          "G3X#24Y#25I0J#18\nN5G90\nM99\n");
    };
    EXPECT_THAT(told(""), ElementsAre(6));
    EXPECT_THAT(told("IF[#500EQ1]GOTO5\n"), IsEmpty());
    EXPECT_THAT(told("IF[#1EQ1]GOTO5\n"), IsEmpty());
    EXPECT_THAT(told("IF[#1EQ2]GOTO5\n"), ElementsAre(7));
}

TEST(CirclesOfCalls, AreNotToldWhereTheProgramWritesAllItsCirclesSo) {
    const std::string odd = "G2X20.Y20.I3.J0\n";
    const std::string program = "O1\nG65P2A1.X1.\nM30\nO2\nG17G91F100.\n" + odd + odd + odd +
                                "IF[#1EQ1]GOTO5\n" + odd + odd + "N5G1X#24\nG90\nM99\n";
    EXPECT_THAT(lines_raised("MAC522", program), IsEmpty()) << "nor where the call passes some of them";
}

TEST(CirclesOfCalls, AreNotToldOfWhatNeverEnds) {
    EXPECT_THAT(lines_raised("MAC522", "O1\nG65P2X5.Y5.R3.\nM30\nO2\nG17G91G1Y10.F100.\nN1IF[#500EQ1]GOTO2\n"
                                       "G3X#24Y#25I0J#18\nN2#100=#100+1\nGOTO1\n"),
                IsEmpty());
}

TEST(CyclesOfCalls, GoDown) {
    const std::string drill = "O2\nG17G90G98G81Z#26R#18F#9\nG80\nM99\n";
    EXPECT_THAT(lines_raised("MAC532", "O1\nG65P2Z-5.R2.F100.\nM30\n" + drill), IsEmpty());
    EXPECT_THAT(lines_raised("MAC532", "O1\nG65P2Z5.R2.F100.\nM30\n" + drill), ElementsAre(5));
    EXPECT_THAT(lines_raised("MAC532", "O1\n#26=5.\n#18=2.\nM98P2\nM30\n" + drill), ElementsAre(7))
        << "a subprogram has the variables of its caller";
    const std::string negates = "O2\nG17G90G98G81Z-#26R#18F#9\nG80\nM99\n";
    EXPECT_THAT(lines_raised("MAC532", "O1\nG65P2Z-5.R2.F100.\nM30\n" + negates), ElementsAre(5));
}

TEST(ShownCalls, AreFollowedWhereNobodyCallsTheProgram) {
    const std::string drill = "G17G90G98G81Z#26R#18F#9\nG80\nM99\n";
    EXPECT_THAT(lines_raised("MAC532", "O2(DRILL)\n(G65 P2 Z5. R2. F100.)\n" + drill), ElementsAre(3));
    EXPECT_THAT(lines_raised("MAC532", "O2(DRILL)\n(G65 P2 Z-5. R2. F100.)\n" + drill), IsEmpty());
    EXPECT_THAT(lines_raised("MAC532", "O2(DRILL)\n(G65 P2 Z5 R2 F100)\n" + drill), IsEmpty())
        << "thousandths";
    EXPECT_THAT(lines_raised("MAC532", "O2(DRILL)\n(G65 P3 Z5. R2. F100.)\n" + drill), IsEmpty())
        << "another program";
    EXPECT_THAT(lines_raised("MAC532", "O1\nG65P2Z-5.R2.F100.\nM30\nO2(DRILL)\n(G65 P2 Z5. R2.)\n" + drill),
                IsEmpty())
        << "it has a caller";
}

TEST(ShownCalls, MayEndInAnAlarm) {
    const std::string asks = "IF[#7EQ#0]GOTO99\nIF[#7GT5]GOTO99\nG0X#7\nM99\nN99#3000=101(D)\n";
    EXPECT_THAT(test::judged("MAC470", "O3(USE)\n(g65 p3 d7 x1.)\n" + asks), ElementsAre("warning 2"));
    EXPECT_THAT(lines_raised("MAC470", "O3(USE)\n(G65 P3 D5 X1.)\n" + asks), IsEmpty());
    EXPECT_THAT(lines_raised("MAC470", "O3(USE)\n(G65 P3 X1. OFFSET IN D)\n" + asks), IsEmpty())
        << "what stands behind it may be an argument";
    EXPECT_THAT(messages_raised("MAC470", "O3(USE)\n(G65 P3 X1.)\n" + asks),
                ElementsAre(HasSubstr("'G65 P3 X1.' leaves #7 (D) vacant")));
}

} // namespace
} // namespace maclint
