//! Which decisions contradict each other, and what conditions are made of.
#include "analyzer/dataflow/conditions.hpp"
#include "tests/support/analysed.hpp"

#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace maclint {
namespace {

/// The conditions of a program of IF blocks, in text order, with what became of each.
using Decisions = std::vector<std::pair<std::string, bool>>;

std::string text_of(const Decisions& decisions) {
    std::string text = "O0001\n";
    for (const auto& [condition, outcome] : decisions) text += "IF[" + condition + "]GOTO9\n";
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

/// The place of the first decision that contradicts those before.
std::optional<std::size_t> contradiction(const Decisions& decisions) {
    const auto workspace = test::analyse_fanuc(text_of(decisions));
    const Program& program = workspace->programs().front().program();
    const auto conditions = conditions_of(program);
    std::vector<dataflow::Decision> made;
    for (std::size_t i = 0; i < decisions.size(); ++i) made.push_back({conditions[i], decisions[i].second});
    return dataflow::first_contradiction(program, made);
}

constexpr auto none = std::nullopt;

TEST(Contradictions, OfOneComparisonAndItsOpposite) {
    EXPECT_EQ(contradiction({{"#1EQ50", true}, {"#1NE50", true}}), 1U);
    EXPECT_EQ(contradiction({{"#1EQ50", true}, {"#1EQ50", false}}), 1U);
    EXPECT_EQ(contradiction({{"#1EQ50", true}, {"#1EQ50", true}}), none);
    EXPECT_EQ(contradiction({{"#1EQ50", true}, {"#2NE50", true}}), none);
    EXPECT_EQ(contradiction({{"#1LE5", true}, {"#1GE5", true}}), none);
    EXPECT_EQ(contradiction({{"#1LT5", true}, {"#1EQ5", true}}), 1U);
    EXPECT_EQ(contradiction({{"#1LE5", false}, {"#1LE5", true}}), 1U);
}

TEST(Contradictions, OfComparisonsWithTwoNumbers) {
    EXPECT_EQ(contradiction({{"#1LT4.5", true}, {"#1GT5.5", true}}), 1U);
    EXPECT_EQ(contradiction({{"#1GT5.5", true}, {"#1LT4.5", true}}), 1U);
    EXPECT_EQ(contradiction({{"#1GT4.5", true}, {"#1LT5.5", true}}), none);
    EXPECT_EQ(contradiction({{"#1EQ4.5", true}, {"#1EQ5.5", true}}), 1U);
    EXPECT_EQ(contradiction({{"#1EQ4.5", true}, {"#1GE5.5", true}}), 1U);
    EXPECT_EQ(contradiction({{"#1EQ5.5", true}, {"#1LE4.5", true}}), 1U);
    EXPECT_EQ(contradiction({{"#1NE4.5", true}, {"#1NE5.5", true}}), none);
    EXPECT_EQ(contradiction({{"#1LT4.5", true}, {"#1LT5.5", true}}), none);
}

TEST(Contradictions, WhoComparesWithWholeNumbersMeansWholeNumbers) {
    EXPECT_EQ(contradiction({{"#1LT5", true}, {"#1GT4", true}}), 1U);
    EXPECT_EQ(contradiction({{"#1LE5", true}, {"#1GT4", true}}), none);
    EXPECT_EQ(contradiction({{"#1GE1", true}, {"#1LE3", true}, {"#1NE1", true}, {"#1NE2", true}}), none);
    EXPECT_EQ(
        contradiction({{"#1GE1", true}, {"#1LE3", true}, {"#1NE1", true}, {"#1NE2", true}, {"#1NE3", true}}),
        4U);
    EXPECT_EQ(contradiction({{"#1GT1", true}, {"#1LT3", true}, {"#1EQ2", true}}), none);
    EXPECT_EQ(contradiction({{"#1GT1", true}, {"#1LT3", true}, {"#1EQ2", false}}), 2U);
}

TEST(Contradictions, AnInputIsZeroOrOne) {
    EXPECT_EQ(contradiction({{"#1000EQ0", false}, {"#1000EQ1", false}}), 1U);
    EXPECT_EQ(contradiction({{"#1EQ0", false}, {"#1EQ1", false}}), none);
    EXPECT_EQ(contradiction({{"#1000GT1", true}}), 0U);
}

TEST(Contradictions, BetweenTwoVariablesWhicheverStandsFirst) {
    EXPECT_EQ(contradiction({{"#1EQ#2", true}, {"#2NE#1", true}}), 1U);
    EXPECT_EQ(contradiction({{"#1LT#2", true}, {"#2LT#1", true}}), 1U);
    EXPECT_EQ(contradiction({{"#1LE#2", true}, {"#2LE#1", true}}), none);
    EXPECT_EQ(contradiction({{"#1LT#2", true}, {"#2LT#3", true}}), none);
}

TEST(Contradictions, OfVacancyTests) {
    EXPECT_EQ(contradiction({{"#1EQ#0", true}, {"#1NE#0", true}}), 1U);
    EXPECT_EQ(contradiction({{"#1EQ#0", true}, {"#1EQ#0", false}}), 1U);
    EXPECT_EQ(contradiction({{"#1EQ#0", true}, {"#2NE#0", true}}), none);
    EXPECT_EQ(contradiction({{"#1EQ#0", true}, {"#1EQ5", true}}), none);
}

TEST(Contradictions, OfLinkedConditionsWhatMustBeTrue) {
    EXPECT_EQ(contradiction({{"[#1EQ1]AND[#2EQ2]", true}, {"#2NE2", true}}), 1U);
    EXPECT_EQ(contradiction({{"[#1EQ1]AND[#2EQ2]", false}, {"#2NE2", true}}), none);
    EXPECT_EQ(contradiction({{"[#1EQ1]OR[#2EQ2]", false}, {"#2EQ2", true}}), 1U);
    EXPECT_EQ(contradiction({{"[#1EQ1]OR[#2EQ2]", true}, {"#2NE2", true}}), none);
}

TEST(Conditions, NameTheVariablesThatTheyRead) {
    const auto workspace =
        test::analyse_fanuc(text_of({{"#1GT[#2+3]", true}, {"#1GT#[#2]", true}, {"#1GT#4003", true}}));
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
    const auto workspace = test::analyse_fanuc(text_of({{"#1GT[#2+3]", true},
                                                        {"#1GT#2+3", true},
                                                        {"#1GT[#2+4]", true},
                                                        {"#1GE[#2+3]", true},
                                                        {"#[#1]EQ#4003", true},
                                                        {"#[#1]EQ#4003", true},
                                                        {"#[#2]EQ#4003", true},
                                                        {"#[#1]EQ#4001", true},
                                                        {"#5041EQ1", true},
                                                        {"#5042EQ1", true}}));
    const Program& program = workspace->programs().front().program();
    const auto conditions = conditions_of(program);
    const auto same = [&](std::size_t a, std::size_t b) {
        return dataflow::same_expression(program, conditions[a], conditions[b]);
    };
    EXPECT_TRUE(same(0, 1)); // brackets aside
    EXPECT_FALSE(same(0, 2));
    EXPECT_FALSE(same(0, 3));
    EXPECT_TRUE(same(4, 5));
    EXPECT_FALSE(same(4, 6));
    EXPECT_FALSE(same(4, 7));
    EXPECT_FALSE(same(8, 9));
}

TEST(Conditions, TellWhetherTheyTestVacancy) {
    const auto workspace =
        test::analyse_fanuc(text_of({{"#1EQ#0", true}, {"[#2EQ1]AND[#1NE#0]", true}, {"#1EQ0", true}}));
    const ProgramAnalysis& analysis = workspace->programs().front();
    const Program& program = analysis.program();
    const auto conditions = conditions_of(program);
    EXPECT_TRUE(dataflow::tests_any_vacancy(program, conditions[0]));
    EXPECT_TRUE(dataflow::tests_any_vacancy(program, conditions[1]));
    EXPECT_FALSE(dataflow::tests_any_vacancy(program, conditions[2]));
    const auto last = static_cast<flow::NodeId>(analysis.graph().nodes.size() - 1);
    EXPECT_TRUE(dataflow::asks_for_vacancy(program, analysis.facts(), 0, last, {0, 1}));
    EXPECT_FALSE(dataflow::asks_for_vacancy(program, analysis.facts(), 0, last, {0, 2}));
    EXPECT_FALSE(dataflow::asks_for_vacancy(program, analysis.facts(), last, last, {0, 1}));
}

} // namespace
} // namespace maclint
