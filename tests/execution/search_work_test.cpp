//! What a path costs: not the blocks on it, but what their conditions compare with what was assumed before.
#include "analyzer/execution/path_run.hpp"
#include "analyzer/queries/paths/feasible_paths.hpp"
#include "analyzer/source/budget.hpp"
#include "tests/support/analysed.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace maclint {
namespace {

/// The comparisons of #600 with so many numbers, joined by that word.
std::string comparisons(std::string_view word, std::string_view operation, int first, int count) {
    std::string text;
    for (int i = first; i < first + count; ++i) {
        if (i > first) text += word;
        text.append("[#600").append(operation).append(std::to_string(i)).append("]");
    }
    return text;
}

/// So many blocks, each of which jumps away where #600 is one of the numbers; those of a block begin `step`
/// after those of the block before. The last node is behind them all.
std::unique_ptr<Workspace> blocks_of_ors(int blocks, int operands, int step) {
    std::string text = "O1\n";
    for (int i = 0; i < blocks; ++i)
        text += "IF[" + comparisons("OR", "EQ", 1 + i * step, operands) + "]GOTO9\n";
    return test::analyse_fanuc(text + "GOTO8\nN9M30\nN8G0X1.\nM30\n");
}

/// Goes past all IFs, none of which jumps.
void pass_all(const flow::Graph& graph, execution::PathRun& run) {
    execution::PathRun::Point point = run.at_start();
    for (flow::NodeId node = 0; node < graph.nodes.size(); ++node)
        for (const flow::EdgeId id : graph.out[node]) {
            if (!graph.edges[id].condition || graph.edges[id].holds) continue;
            const auto next = run.along(id, run.run(node, point));
            ASSERT_TRUE(next.has_value());
            point = *next;
        }
}

constexpr std::size_t no_bound = 1'000'000'000;

std::size_t work_past(int blocks, int operands, int step) {
    const auto workspace = blocks_of_ors(blocks, operands, step);
    const ProgramAnalysis& program = workspace->programs().front();
    execution::SearchWork work;
    execution::PathRun run(program, work, no_bound);
    pass_all(program.graph(), run);
    return work.done();
}

TEST(SearchWork, IsTheSameForEachConditionThatWasAskedBefore) {
    EXPECT_LT(10 * work_past(80, 20, 0), 22 * work_past(40, 20, 0));
}

TEST(SearchWork, IsMoreForEachConditionTheMoreIsAssumed) {
    EXPECT_GT(work_past(80, 20, 20), 3 * work_past(40, 20, 20));
}

/// Evaluating is what costs, and is done a few times for each, not with each that follows in the chain.
TEST(SearchWork, OfAChainGrowsWithItsComparisons) {
    constexpr std::size_t operands = 100;
    EXPECT_LT(work_past(1, operands, 1), 400 * operands);
}

TEST(SearchWork, OfAStepCountsForEachSearchButIsDoneOnce) {
    const auto workspace = blocks_of_ors(5, 20, 20);
    const ProgramAnalysis& program = workspace->programs().front();
    execution::SearchWork work;
    execution::PathRun run(program, work, no_bound);
    const Budget plenty(no_bound);
    pass_all(program.graph(), run);
    EXPECT_FALSE(plenty.is_spent());
    const std::size_t done = work.done();
    const Budget little(done - 1);
    pass_all(program.graph(), run);
    EXPECT_TRUE(little.is_spent());
    EXPECT_EQ(work.done(), done);
}

TEST(SearchWork, OfOneStepIsBounded) {
    const auto workspace = blocks_of_ors(1, 250, 1);
    const ProgramAnalysis& program = workspace->programs().front();
    constexpr std::size_t most = 1000; // of some 60,000, and all 250 are evaluated
    execution::SearchWork work;
    execution::PathRun run(program, work, most);
    const Budget budget(most);
    pass_all(program.graph(), run);
    EXPECT_TRUE(budget.is_spent());
    EXPECT_LT(work.done(), 40 * most);
}

/// A path to the last node but one, behind all conditions.
execution::PathFound path_behind(const ProgramAnalysis& program) {
    execution::PathSearch search(program);
    const auto last = static_cast<flow::NodeId>(program.graph().nodes.size() - 1);
    return search.find(std::array{execution::Leg{last, {}}});
}

TEST(SearchWork, EndsASearchAndTheNextOneForTheSamePath) {
    EXPECT_TRUE(path_behind(blocks_of_ors(10, 120, 120)->programs().front()).path.has_value());
    EXPECT_TRUE(path_behind(blocks_of_ors(80, 120, 0)->programs().front()).path.has_value());
    const auto workspace = blocks_of_ors(40, 120, 120);
    const ProgramAnalysis& program = workspace->programs().front();
    for (int time = 0; time < 2; ++time) {
        const execution::PathFound found = path_behind(program);
        EXPECT_FALSE(found.path.has_value());
        EXPECT_TRUE(found.gave_up);
        EXPECT_LT(found.visits, 100U);
    }
}

} // namespace
} // namespace maclint
