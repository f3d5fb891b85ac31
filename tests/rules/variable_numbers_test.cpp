//! Rules on the numbers of variables: what a control lacks, protects, and what may be stored.
#include "tests/rules/raised.hpp"
#include "tests/support/linted.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using test::judged;
using test::messages_raised;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// "error MAC203 (116)" for each finding of a macro with that block.
std::vector<std::string> numbers_found(const std::string& block, std::string_view control) {
    static constexpr const char* severities[] = {"note", "warning", "error"};
    cli::Overrides overrides;
    overrides.control = std::string(control);
    std::vector<std::string> all;
    for (const auto& [finding, suppressed] :
         test::lint_texts({{"O1.nc", "O9001\n" + block + "\nM99\n"}}, std::move(overrides)).findings)
        all.push_back(std::string(severities[static_cast<int>(finding.severity)]) + " " +
                      std::string(finding.rule->code) +
                      (finding.alarm.empty() ? "" : " (" + std::string(finding.alarm) + ")"));
    return all;
}

TEST(VariableNumbers, ThatNoRowOfTheNamedControlHoldsStopIt) {
    EXPECT_THAT(numbers_found("G0 X#40", "fanuc-16i"), ElementsAre("error MAC202 (115)"));
    EXPECT_THAT(numbers_found("#99=1", "fanuc-30i"), ElementsAre("error MAC202 (115)"));
    EXPECT_THAT(numbers_found("#[30+10]=1", "fanuc-30i"), ElementsAre("error MAC202 (115)"));
    EXPECT_THAT(numbers_found("#133=#533", "fanuc-16i"), IsEmpty());
    EXPECT_THAT(numbers_found("G0 X#40", "fanuc"), IsEmpty()) << "it may be for another control";
    EXPECT_THAT(judged("MAC202", "O9001\nG0 X#40\nM99\n"), ElementsAre("warning 2"))
        << "told where asked for";
}

TEST(VariableNumbers, BetweenModalValuesAreALikelySlip) {
    EXPECT_THAT(numbers_found("IF[#4112EQ5]GOTO9\nG0 X1.\nN9", "fanuc-16i"), ElementsAre("warning MAC202"));
    EXPECT_THAT(numbers_found("IF[#4112EQ5]GOTO9\nG0 X1.\nN9", "haas"), IsEmpty())
        << "a Haas has one for each letter";
    EXPECT_THAT(numbers_found("IF[#4111EQ5]GOTO9\nG0 X1.\nN9", "fanuc-16i"), IsEmpty());
    EXPECT_THAT(numbers_found("IF[#4611EQ5]GOTO9\nG0 X1.\nN9", "fanuc"), ElementsAre("warning MAC202"));
    EXPECT_THAT(messages_raised("MAC202", "O9001\n#1=#4611\n#2=#4611\nG0 X#1 Y#2\nM99\n"),
                ElementsAre(HasSubstr("no list of system variables holds '#4611'"),
                            HasSubstr("no list of system variables holds '#4611'")));
}

TEST(ProtectedVariables, AreNotWritten) {
    EXPECT_THAT(numbers_found("#1000=1", "fanuc-16i"), ElementsAre("error MAC203 (116)"));
    EXPECT_THAT(numbers_found("#4001=1", "fanuc-30i"), ElementsAre("error MAC203 (116)"));
    EXPECT_THAT(numbers_found("#[5000+1]=1", "fanuc-30i"), ElementsAre("error MAC203 (116)"));
    EXPECT_THAT(numbers_found("IF[#500EQ1]THEN #5041=0", "fanuc-16i"), ElementsAre("error MAC203 (116)"));
    EXPECT_THAT(numbers_found("#5041=0", "haas"), ElementsAre("warning MAC203"));
    EXPECT_THAT(numbers_found("#5121=0", "fanuc-30i"), ElementsAre("warning MAC203"))
        << "no document tells of it";
    EXPECT_THAT(numbers_found("#3101=3", "fanuc-30i"), ElementsAre("warning MAC203"));
    EXPECT_THAT(numbers_found("#11000=1", "haas"), ElementsAre("warning MAC203"));
    EXPECT_THAT(numbers_found("#11000=1", "fanuc-16i"), IsEmpty()) << "a tool offset";
    EXPECT_THAT(numbers_found("#0=1", "fanuc-30i"), ElementsAre("error MAC201 (116)"));
    for (const char* block : {"#5221=0", "#1100=1", "#2001=0", "#3901=0", "#3001=0"})
        EXPECT_THAT(numbers_found(block, "fanuc-16i"), IsEmpty()) << block;
}

TEST(WriteOnlyVariables, AreNotRead) {
    EXPECT_THAT(numbers_found("IF[#3006EQ1]GOTO9\nG0 X1.\nN9", "fanuc-30i"),
                ElementsAre("error MAC231 (1115)"));
    EXPECT_THAT(numbers_found("IF[#3000GT0]GOTO9\nG0 X1.\nN9", "fanuc-16i"), ElementsAre("warning MAC231"));
    EXPECT_THAT(judged("MAC231", "O9001\n#3006=1(TURN)\n#500=#3001\nM99\n"), IsEmpty());
}

TEST(Suppression, TakesTheSumOfItsBits) {
    EXPECT_THAT(messages_raised("MAC232", "O9001\n#3003=4\nM99\n"),
                ElementsAre(HasSubstr("'#3003=4' sets single-block suppression, which takes 0 to 3")));
    EXPECT_THAT(judged("MAC232", "O9001\n#3004=8\n#3004=-1\n#3004=1.5\nM99\n"),
                ElementsAre("warning 2", "warning 3", "warning 4"));
    EXPECT_THAT(judged("MAC232", "O9001\n#3003=3\n#3004=7\n#3003=#1\nM99\n"), IsEmpty());
}

TEST(AlarmNumbers, AreToldAboveAllThatIsPrinted) {
    EXPECT_THAT(judged("MAC601", "O9001\n#3000=9999(A)\nM99\n"), IsEmpty());
    EXPECT_THAT(judged("MAC601", "O9001\n#3000=10000(A)\nM99\n"), ElementsAre("warning 2"));
    EXPECT_THAT(messages_raised("MAC601", "O9001\nIF[#1EQ#0]THEN #3000=-1(A)\nM99\n"),
                ElementsAre(HasSubstr("'#3000=-1' is no whole number from 0 on")));
    EXPECT_THAT(judged("MAC601", "O9001\n#3000=#1(A)\nM99\n"), IsEmpty());
}

} // namespace
} // namespace maclint
