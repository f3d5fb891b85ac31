//! Which decisions contradict each other, and what conditions are made of.
#include "analyzer/dataflow/domain/read_set.hpp"
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/queries/conditions.hpp"
#include "analyzer/queries/unset_reads.hpp"
#include "tests/support/analysed.hpp"
#include "tests/support/hand_built.hpp"

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
    std::vector<queries::Decision> made;
    for (std::size_t i = 0; i < decisions.size(); ++i) made.push_back({conditions[i], decisions[i].second});
    return queries::first_contradiction(program, made);
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
    EXPECT_EQ(contradiction({{"#1GT1.5", true}, {"#1LT2", true}}), none); // who does not, does not
    EXPECT_EQ(contradiction({{"#1NE2", true}, {"#1GE2", true}, {"#1LE2", true}}), 2U);
    EXPECT_EQ(contradiction({{"#1NE2", true}, {"#1GE2", true}, {"#1LE3", true}}), none);
    EXPECT_EQ(contradiction({{"#1GE2", true}, {"#1LE3", true}, {"#1NE#4", true}, {"#1NE5", true}}), none);
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

TEST(Contradictions, OfEachComparisonWithEachOther) {
    // Below, at and above 5: two comparisons agree where they share one of the three.
    const std::vector<std::pair<std::string, unsigned>> all{{"LT", 1}, {"EQ", 2}, {"GT", 4},
                                                            {"LE", 3}, {"NE", 5}, {"GE", 6}};
    for (const auto& [one, where_one] : all)
        for (const auto& [other, where_other] : all) {
            const auto expected = (where_one & where_other) == 0 ? std::optional<std::size_t>(1) : none;
            EXPECT_EQ(contradiction({{"#1" + one + "#2", true}, {"#1" + other + "#2", true}}), expected)
                << one << other;
            EXPECT_EQ(contradiction({{"#1" + one + "5.5", true}, {"#1" + other + "5.5", true}}), expected)
                << one << other;
        }
}

TEST(Contradictions, OfEachComparisonWithASmallerAndEachWithALargerNumber) {
    // Below 4.5, at it, between the two, at 5.5, above it.
    const std::vector<std::pair<std::string, unsigned>> smaller{{"LT", 1}, {"EQ", 2},  {"GT", 28},
                                                                {"LE", 3}, {"NE", 29}, {"GE", 30}};
    const std::vector<std::pair<std::string, unsigned>> larger{{"LT", 7},  {"EQ", 8},  {"GT", 16},
                                                               {"LE", 15}, {"NE", 23}, {"GE", 24}};
    for (const auto& [one, where_one] : smaller)
        for (const auto& [other, where_other] : larger) {
            const auto expected = (where_one & where_other) == 0 ? std::optional<std::size_t>(1) : none;
            EXPECT_EQ(contradiction({{"#1" + one + "4.5", true}, {"#1" + other + "5.5", true}}), expected)
                << one << other;
            EXPECT_EQ(contradiction({{"#1" + other + "5.5", true}, {"#1" + one + "4.5", true}}), expected)
                << other << one;
        }
}

TEST(Contradictions, AreFoundAtTheEndOfALongWay) {
    Decisions decisions;
    for (int i = 0; i < 300; ++i) decisions.emplace_back("#" + std::to_string(500 + i) + "EQ1", true);
    EXPECT_EQ(contradiction(decisions), none);
    decisions.emplace_back("#700EQ2", true);
    EXPECT_EQ(contradiction(decisions), 300U);
}

TEST(Contradictions, OfVacancyTests) {
    EXPECT_EQ(contradiction({{"#1EQ#0", true}, {"#1NE#0", true}}), 1U);
    EXPECT_EQ(contradiction({{"#1EQ#0", true}, {"#1EQ#0", false}}), 1U);
    EXPECT_EQ(contradiction({{"#1EQ#0", true}, {"#2NE#0", true}}), none);
    EXPECT_EQ(contradiction({{"#1EQ#0", true}, {"#1EQ5", true}}), none);
    EXPECT_EQ(contradiction({{"#1EQ5", true}, {"#1EQ#0", true}}), none);
    EXPECT_EQ(contradiction({{"#1NE#0", true}, {"#1NE#0", true}}), none);
    EXPECT_EQ(contradiction({{"#1NE#0", true}, {"#1NE#0", false}}), 1U);
}

TEST(Contradictions, OfLinkedConditionsWhatMustBeTrue) {
    EXPECT_EQ(contradiction({{"[#1EQ1]AND[#2EQ2]", true}, {"#2NE2", true}}), 1U);
    EXPECT_EQ(contradiction({{"[#1EQ1]AND[#2EQ2]", false}, {"#2NE2", true}}), none);
    EXPECT_EQ(contradiction({{"[#1EQ1]OR[#2EQ2]", false}, {"#2EQ2", true}}), 1U);
    EXPECT_EQ(contradiction({{"[#1EQ1]OR[#2EQ2]", true}, {"#2NE2", true}}), none);
    EXPECT_EQ(contradiction({{"NOT[#1EQ1]", true}, {"#1EQ1", true}}), 1U);
    EXPECT_EQ(contradiction({{"NOT[#1EQ1]", false}, {"#1EQ1", true}}), none);
    EXPECT_EQ(contradiction({{"NOT[[#1EQ1]AND[#2EQ2]]", false}, {"#2NE2", true}}), 1U);
    EXPECT_EQ(contradiction({{"[#1EQ1]AND[#1EQ2]", true}}), 0U);
    EXPECT_EQ(contradiction({{"[#1EQ1]XOR[#2EQ2]", true}, {"#2NE2", true}, {"#1NE1", true}}), none);
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
    const auto workspace = test::analyse_fanuc(text_of({{"#1", true}, {"-#1", true}, {"5", true}}));
    const Program& program = workspace->programs().front().program();
    const auto conditions = conditions_of(program);
    EXPECT_EQ(queries::plain_variable(program, conditions[0]), (Variable{0, 1}));
    EXPECT_EQ(queries::plain_variable(program, conditions[1]), none);
    EXPECT_EQ(queries::plain_variable(program, conditions[2]), none);
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

TEST(Conditions, TellWhetherTheyTestVacancy) {
    const auto workspace =
        test::analyse_fanuc(text_of({{"#1EQ#0", true}, {"[#2EQ1]AND[#1NE#0]", true}, {"#1EQ0", true}}));
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
