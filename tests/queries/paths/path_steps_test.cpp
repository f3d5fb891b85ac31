//! Of a path only those steps are told that say where the program went.
#include "analyzer/queries/paths/path_steps.hpp"
#include "tests/support/analysed.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::queries {
namespace {

/// The first node of a line.
flow::NodeId node_in_line(const ProgramAnalysis& analysis, std::uint32_t line) {
    flow::NodeId node = 0;
    while (test::line_of(analysis, analysis.graph().nodes.at(node).part.begin) != line) ++node;
    return node;
}

/// The texts of the last steps, at most so many, of the shortest path to the line's first node.
std::vector<std::string> steps_to_line(const std::string& text, std::uint32_t line, std::size_t most) {
    const auto workspace = test::analyse_fanuc(text);
    const ProgramAnalysis& analysis = workspace->programs().front();
    const flow::NodeId to = node_in_line(analysis, line);
    const auto path = shortest_path(analysis, 0, to);
    std::vector<std::string> texts;
    if (!path) return {"no path"};
    for (const flow::EdgeId step : telling_steps(analysis, *path, most))
        texts.push_back(test::text_of(analysis, span_of_step(analysis, step)));
    return texts;
}

TEST(TellingSteps, AreJumpsAndBranchesInTheOrderOfThePath) {
    const std::string text = "O1\nIF[#501EQ1]GOTO5\n#1=1\nX#1\nN5GOTO6\nM30\n"
                             "N6IF[#502EQ1]GOTO7\n#1=2\nX#1\nN7X#2\nM30\n";
    EXPECT_THAT(steps_to_line(text, 10, 12),
                testing::ElementsAre("[#501EQ1]", "GOTO5", "GOTO6", "[#502EQ1]", "GOTO7"));
}

TEST(TellingSteps, LeaveOutBranchesWhoseOtherSideDoesNotLeadThere) {
    // Both sides of the first IF lead to the end, of the second one only the way past the alarm.
    const std::string text = "O1\nIF[#501EQ1]THEN#1=1\nIF[#502EQ1]GOTO7\nG0X1.\nM30\nN7#3000=1(NO)\n";
    const auto steps = steps_to_line(text, 5, 12);
    EXPECT_THAT(steps, testing::Contains("[#501EQ1]"));
    EXPECT_THAT(steps, testing::Not(testing::Contains("[#502EQ1]")));
}

TEST(TellingSteps, AreTheLastOnes) {
    const std::string text = "O1\nGOTO1\nM30\nN1GOTO2\nM30\nN2GOTO3\nM30\nN3M30\n";
    EXPECT_THAT(steps_to_line(text, 8, 2), testing::ElementsAre("GOTO2", "GOTO3"));
    EXPECT_THAT(steps_to_line(text, 8, 0), testing::IsEmpty());
}

TEST(Steps, AreShownAtTheConditionOrTheBlockThatLeadsOnOrIsSkipped) {
    const auto workspace = test::analyse_fanuc("O1\nWHILE[#1LT5]DO1\n#1=#1+1\nEND1\nX#2\n/X#1\nM30\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    std::vector<std::string> texts;
    for (flow::EdgeId edge = 0; edge < analysis.graph().edges.size(); ++edge)
        texts.push_back(test::text_of(analysis, span_of_step(analysis, edge)));
    EXPECT_THAT(texts, testing::UnorderedElementsAre("O1", "[#1LT5]", "#1=#1+1", "END1", "[#1LT5]", "X#2",
                                                     "/X#1", "/X#1"));
}

TEST(ShortestPaths, LeadFromEveryNodeAndNowhereWherePathsEnd) {
    const auto workspace = test::analyse_fanuc("O1\nX#1\nX#2\nGOTO5\nX#3\nN5X#4\nM30\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    const auto length = [&](std::uint32_t from, std::uint32_t to) -> std::optional<std::size_t> {
        const auto path = shortest_path(analysis, node_in_line(analysis, from), node_in_line(analysis, to));
        return path ? std::optional(path->size()) : std::nullopt;
    };
    EXPECT_EQ(length(3, 6), 2U);
    EXPECT_EQ(length(1, 1), 0U);
    EXPECT_EQ(length(3, 3), std::nullopt); // no round leads back
    EXPECT_EQ(length(3, 5), std::nullopt);
    EXPECT_EQ(length(6, 3), std::nullopt);
}

} // namespace
} // namespace maclint::queries
