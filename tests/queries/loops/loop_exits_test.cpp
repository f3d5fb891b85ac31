//! What closes a loop, and whether anything that decides over its exits can change.
#include "analyzer/queries/loops/loop_exits.hpp"
#include "tests/support/analysed.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::queries {
namespace {

/// The numbers of the variables that decide over the only loop's exits and cannot change; nothing when one
/// can.
std::optional<std::vector<std::int32_t>> deciders_of(const std::string& text) {
    const auto workspace = test::analyse_fanuc("O9001\n" + text + "N98M99\nN99M99\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    EXPECT_EQ(analysis.loops().size(), 1U);
    const auto deciders = unchanging_deciders(analysis, analysis.loops().front());
    if (!deciders) return std::nullopt;
    std::vector<std::int32_t> numbers;
    for (const Variable variable : *deciders) numbers.push_back(variable.number);
    return numbers;
}

std::optional<std::vector<std::int32_t>> numbers(std::vector<std::int32_t> of) { return of; }

TEST(Deciders, AreTheVariablesOfAllExitsOnce) {
    EXPECT_EQ(deciders_of("WHILE[#1LT#2]DO1\nG0X1.\nIF[#1GT#3]GOTO99\nEND1\n"), numbers({1, 2, 3}));
    EXPECT_EQ(deciders_of("WHILE[1EQ1]DO1\nG0X1.\nEND1\n"), numbers({}));
}

TEST(Deciders, AreNoneWhenSomethingCanChange) {
    EXPECT_EQ(deciders_of("WHILE[#1LT#2]DO1\n#2=#2-1\nEND1\n"), std::nullopt);
    EXPECT_EQ(deciders_of("WHILE[#1LT#5003]DO1\nG0X1.\nEND1\n"), std::nullopt);
    EXPECT_EQ(deciders_of("WHILE[#1LT#2]DO1\nG0X1.\nIF[#3EQ1]GOTO99\n#3=1\nEND1\n"), std::nullopt);
}

TEST(Deciders, MayBeSetBySomebodyElseWhileTheLoopWaits) {
    EXPECT_EQ(deciders_of("WHILE[#501LT2]DO1\nG4X1.\nEND1\n"), std::nullopt);
    EXPECT_EQ(deciders_of("WHILE[#501LT2]DO1\nG0X1.\nEND1\n"), numbers({501}));
    EXPECT_EQ(deciders_of("WHILE[#501LT2]DO1\n#3=1\nEND1\n"), numbers({501}));
    EXPECT_EQ(deciders_of("WHILE[#1LT2]DO1\nG4X1.\nEND1\n"), numbers({1})); // of its own level
}

/// What repeats the only loop, and whether it is a WHILE or DO of the text.
std::pair<std::string, bool> repetition_of(const std::string& text) {
    const auto workspace = test::analyse_fanuc("O9001\n" + text);
    const ProgramAnalysis& analysis = workspace->programs().front();
    EXPECT_EQ(analysis.loops().size(), 1U);
    const dataflow::Loop& loop = analysis.loops().front();
    const std::string span = test::text_of(analysis, span_of_repetition(analysis, loop));
    const auto by = repeated_by(analysis, loop);
    EXPECT_TRUE(!by || test::text_of(analysis, analysis.program().effects[*by].span) == span);
    return {span, region_of(analysis, loop) != nullptr};
}

TEST(Repetition, IsTheHeadOfALoopOrTheJumpBack) {
    EXPECT_EQ(repetition_of("WHILE[#1LT9]DO1\n#1=#1+1\nEND1\nM99\n"),
              std::pair(std::string("WHILE[#1LT9]DO1"), true));
    EXPECT_EQ(repetition_of("N1#1=#1+1\nIF[#1LT9]GOTO1\nM99\n"), std::pair(std::string("GOTO1"), false));
}

TEST(EndlessJumps, AreCyclesThatNoBlockLeavesAndNoLoopOfTheTextCloses) {
    const auto cycles = [](const std::string& text) {
        const auto workspace = test::analyse_fanuc("O1\n" + text + "M30\n");
        const ProgramAnalysis& analysis = workspace->programs().front();
        EXPECT_EQ(analysis.loops().size(), 1U);
        return is_in_endless_jumps(analysis, analysis.loops().front());
    };
    EXPECT_TRUE(cycles("N1G0X1.\nGOTO1\n"));
    EXPECT_FALSE(cycles("N1G0X1.\nIF[#501EQ1]GOTO9\nGOTO1\nN9"));
    EXPECT_FALSE(cycles("DO1\nG0X1.\nEND1\n"));
}

/// Whether the first condition is that of a loop which never ends.
bool never_ends_in(std::string_view dialect, const std::string& text) {
    const auto workspace = test::analyse_text(dialect, text);
    const ProgramAnalysis& analysis = workspace->programs().front();
    const dataflow::Condition& condition = analysis.facts().all<dataflow::Condition>().front();
    EXPECT_TRUE(is_loop_condition(analysis, condition));
    return never_ends(analysis, condition);
}

TEST(EndlessLoops, HaveAConditionWithoutVariablesAndNothingThatStopsThem) {
    const auto din = [](const std::string& condition, const std::string& body) {
        return never_ends_in("dinplus",
                             "MACHINING\nN1 WHILE " + condition + "\n" + body + "N4 ENDWHILE\nN5 M30\nEND\n");
    };
    EXPECT_TRUE(din("1==1", "N2 G0 X10\n"));
    EXPECT_FALSE(din("#l1==1", "N2 G0 X10\n"));
    EXPECT_FALSE(din("1==1", "N2 M30\n"));
    // Where a jump may leave a loop, such a condition is a custom.
    EXPECT_FALSE(never_ends_in("fanuc", "O1\nWHILE[1EQ1]DO1\nG0X1.\nEND1\nM30\n"));
}

} // namespace
} // namespace maclint::queries
