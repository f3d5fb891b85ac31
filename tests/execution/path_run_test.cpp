//! A path can be taken where its decisions do not contradict each other, nor what is known.
#include "analyzer/execution/path_run.hpp"
#include "tests/support/analysed.hpp"

#include <algorithm>
#include <optional>
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

/// The edges that the conditions decide, in text order, as they turned out.
std::vector<flow::EdgeId> decided(const flow::Graph& graph, const Decisions& decisions) {
    std::vector<flow::EdgeId> edges;
    for (flow::NodeId node = 0; node < graph.nodes.size(); ++node)
        for (const flow::EdgeId id : graph.out[node])
            if (graph.edges[id].condition && edges.size() < decisions.size() &&
                graph.edges[id].holds == decisions[edges.size()].second)
                edges.push_back(id);
    return edges;
}

/// The place of the first decision that cannot turn out so after those before it.
std::optional<std::size_t> contradiction(const Decisions& decisions) {
    const auto workspace = test::analyse_fanuc(text_of(decisions));
    const ProgramAnalysis& program = workspace->programs().front();
    const std::vector<flow::EdgeId> edges = decided(program.graph(), decisions);
    EXPECT_EQ(edges.size(), decisions.size());
    execution::SearchWork work;
    execution::PathRun run(program, work, 1'000'000);
    execution::PathRun::Point point = run.at_start();
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const auto next = run.along(edges[i], run.run(program.graph().edges[edges[i]].from, point));
        if (!next) return i;
        point = *next;
    }
    return std::nullopt;
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
    EXPECT_EQ(contradiction({{"[#1000-0.5]LT0", true}}), none); // is no whole number
    EXPECT_EQ(contradiction({{"[#1000-0.5]LT-0.5", true}}), 0U);
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
    EXPECT_EQ(contradiction({{"#1EQ#0", true}, {"#1EQ5", true}}), 1U);
    EXPECT_EQ(contradiction({{"#1EQ5", true}, {"#1EQ#0", true}}), 1U);
    EXPECT_EQ(contradiction({{"#1EQ#0", true}, {"#1LT5", true}}), none); // vacant counts as 0 here
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

} // namespace
} // namespace maclint
