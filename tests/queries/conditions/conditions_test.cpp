//! What conditions are made of.
#include "analyzer/dataflow/domain/read_set.hpp"
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/queries/conditions/conditions.hpp"
#include "analyzer/queries/vacancy/unset_reads.hpp"
#include "tests/support/analysed.hpp"
#include "tests/support/hand_built.hpp"

#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace maclint {
namespace {

/// A program of IF blocks.
std::string text_of(const std::vector<std::string>& conditions) {
    std::string text = "O0001\n";
    for (const std::string& condition : conditions) text += "IF[" + condition + "]GOTO9\n";
    return text + "N9M99\n";
}

std::vector<ExpressionId> conditions_of(const Program& program) {
    std::vector<ExpressionId> conditions;
    for_each_effect(program, [&](EffectId id) {
        if (const auto* guarded = std::get_if<Guarded>(&program.effects[id].what))
            conditions.push_back(guarded->condition);
    });
    return conditions;
}

TEST(Conditions, NameTheVariablesThatTheyRead) {
    const auto workspace = test::analyse_fanuc(text_of({"#1GT[#2+3]", "#1GT#[#2]", "#1GT#4003"}));
    const Program& program = workspace->programs().front().program();
    const auto conditions = conditions_of(program);
    const auto first = dataflow::variables_of(program, conditions[0]);
    EXPECT_TRUE(first.closed);
    ASSERT_EQ(first.variables.size(), 2U);
    EXPECT_EQ(first.variables[0].number, 1);
    EXPECT_EQ(first.variables[1].number, 2);
    EXPECT_FALSE(dataflow::variables_of(program, conditions[1]).closed);
    EXPECT_FALSE(dataflow::variables_of(program, conditions[2]).closed);
}

TEST(Conditions, AreTheSameWhenTheySayTheSame) {
    const auto workspace = test::analyse_fanuc(
        text_of({"#1GT[#2+3]", "#1GT#2+3", "#1GT[#2+4]", "#1GE[#2+3]", "#[#1]EQ#4003", "#[#1]EQ#4003",
                 "#[#2]EQ#4003", "#[#1]EQ#4001", "#5041EQ1", "#5042EQ1"}));
    const Program& program = workspace->programs().front().program();
    const auto conditions = conditions_of(program);
    const auto same = [&](std::size_t a, std::size_t b) {
        return queries::same_expression(program, conditions[a], conditions[b]);
    };
    EXPECT_TRUE(same(0, 1)); // brackets aside
    EXPECT_FALSE(same(0, 2));
    EXPECT_FALSE(same(0, 3));
    EXPECT_TRUE(same(4, 5));
    EXPECT_FALSE(same(4, 6));
    EXPECT_FALSE(same(4, 7));
    EXPECT_FALSE(same(8, 9));
}

TEST(Conditions, WithDifferentNamesDiffer) {
    test::HandBuilt built("MAIN.MPF", "M30\n");
    const ExpressionId here = built.name("HERE"), there = built.name("THERE"), zero = built.number(0);
    built.block({Stop{}});
    const auto workspace = test::analyse({built.finish()}, {.complete = true, .jobs = 1});
    const Program& program = workspace->programs().front().program();
    EXPECT_TRUE(queries::same_expression(program, here, here));
    EXPECT_FALSE(queries::same_expression(program, here, there));
    EXPECT_FALSE(queries::same_expression(program, here, zero));
    EXPECT_FALSE(queries::same_expression(program, zero, here));
}

TEST(Conditions, OfAVariableAloneNameIt) {
    const auto workspace = test::analyse_fanuc(text_of({"#1", "-#1", "5"}));
    const Program& program = workspace->programs().front().program();
    const auto conditions = conditions_of(program);
    EXPECT_EQ(queries::plain_variable(program, conditions[0]), (Variable{0, 1}));
    EXPECT_EQ(queries::plain_variable(program, conditions[1]), std::nullopt);
    EXPECT_EQ(queries::plain_variable(program, conditions[2]), std::nullopt);
}

TEST(Conditions, ComeAcrossVacantVariablesWhereTheControlHasThem) {
    const auto fanuc = test::analyse_fanuc("O0001\n#1=1\nM30\n");
    const auto dinplus = test::analyse_text("dinplus", "MACHINING\n#l1=1\nM30\n");
    const Program& mill = fanuc->programs().front().program();
    const Program& lathe = dinplus->programs().front().program();
    EXPECT_TRUE(queries::may_hold_vacant(mill, {0, 1}));
    EXPECT_TRUE(queries::may_hold_vacant(mill, {2, 500}));
    EXPECT_FALSE(queries::may_hold_vacant(lathe, {0, 1})); // what a local holds at first is not defined
}

TEST(Conditions, TestForZeroByEqualityAlone) {
    const auto tests_zero = [](const std::string& condition) {
        const auto workspace = test::analyse_fanuc(text_of({condition}));
        const ProgramAnalysis& analysis = workspace->programs().front();
        return queries::zero_test_of(analysis, analysis.facts().all<dataflow::Read>().front()) != nullptr;
    };
    for (const std::string condition : {"#1EQ0", "#1NE0", "0EQ#1"})
        EXPECT_TRUE(tests_zero(condition)) << condition;
    for (const std::string condition : {"#1LT0", "#1GT0", "#1EQ1", "-#1EQ0"})
        EXPECT_FALSE(tests_zero(condition)) << condition;
}

TEST(Conditions, TellWhetherTheyTestVacancy) {
    const auto workspace = test::analyse_fanuc(text_of({"#1EQ#0", "[#2EQ1]AND[#1NE#0]", "#1EQ0"}));
    const ProgramAnalysis& analysis = workspace->programs().front();
    const Program& program = analysis.program();
    const auto conditions = conditions_of(program);
    EXPECT_TRUE(queries::tests_any_vacancy(program, conditions[0]));
    EXPECT_TRUE(queries::tests_any_vacancy(program, conditions[1]));
    EXPECT_FALSE(queries::tests_any_vacancy(program, conditions[2]));
    const auto last = static_cast<flow::NodeId>(analysis.graph().nodes.size() - 1);
    EXPECT_TRUE(queries::asks_for_vacancy(program, analysis.facts(), 0, last, {0, 1}));
    EXPECT_FALSE(queries::asks_for_vacancy(program, analysis.facts(), 0, last, {0, 2}));
    EXPECT_FALSE(queries::asks_for_vacancy(program, analysis.facts(), last, last, {0, 1}));
    const flow::NodeId first_test = analysis.facts().all<dataflow::Comparison>()[0].node;
    const flow::NodeId second_test = analysis.facts().all<dataflow::Comparison>()[2].node;
    const auto asks = [&](flow::NodeId from, flow::NodeId to) {
        return queries::asks_for_vacancy(program, analysis.facts(), from, to, {0, 1});
    };
    EXPECT_TRUE(asks(first_test, first_test));
    EXPECT_TRUE(asks(second_test, second_test));
    EXPECT_FALSE(asks(first_test + 1, second_test - 1));
    EXPECT_FALSE(asks(second_test + 1, last));
}

} // namespace
} // namespace maclint
