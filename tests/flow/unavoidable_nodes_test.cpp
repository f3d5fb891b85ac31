//! Nodes that no path leads around.
#include "analyzer/flow/unavoidable_nodes.hpp"
#include "tests/support/analysed.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// The moves among them, as they stand: "X1.".
std::vector<std::string> unavoidable_moves(const std::string& text) {
    const auto workspace = test::analyse_fanuc("O1\n" + text);
    const ProgramAnalysis& analysis = workspace->programs().front();
    const flow::Graph& graph = analysis.graph();
    const auto unavoidable = flow::unavoidable_nodes(graph.nodes.size(), graph.edges, graph.out, graph.exits);
    std::vector<std::string> moves;
    for (flow::NodeId node = 0; node < graph.nodes.size(); ++node) {
        const std::string block = test::text_of(analysis, graph.nodes[node].part);
        const auto at = block.find('X');
        if (unavoidable[node] && at != std::string::npos) moves.push_back(block.substr(at));
    }
    return moves;
}

TEST(UnavoidableNodes, AreThoseThatEveryPathToAnExitComesBy) {
    EXPECT_THAT(unavoidable_moves("X1.\nM30\n"), ElementsAre("X1."));
    EXPECT_THAT(unavoidable_moves("IF[#1EQ1]GOTO5\nX1.\nN5\nM1\nX2.\nM30\n"), ElementsAre("X2."));
    EXPECT_THAT(unavoidable_moves("IF[#1EQ1]GOTO5\nX1.\nGOTO6\nN5X2.\nN6X3.\nM30\n"), ElementsAre("X3."));
    // Three branches, of which the nearest exit is not on the shortest way to the farther ones.
    EXPECT_THAT(unavoidable_moves("IF[#1EQ1]GOTO5\nX1.\nIF[#1EQ2]GOTO6\nX2.\nM30\nN5X3.\nM30\nN6X4.\nM30\n"),
                IsEmpty());
    EXPECT_THAT(unavoidable_moves("/GOTO5\nX1.\nN5M30\n"), IsEmpty());
    EXPECT_THAT(unavoidable_moves("#2=0\nWHILE[#2LT5]DO1\n#2=#2+1\nX1.\nEND1\nX2.\nM30\n"),
                ElementsAre("X2."));
}

TEST(UnavoidableNodes, AreNotAvoidedByAnAlarmButWhereThereIsNoOtherExit) {
    EXPECT_THAT(unavoidable_moves("IF[#1EQ1]GOTO5\nX1.\nM30\nN5#3000=1\n"), ElementsAre("X1."));
    EXPECT_THAT(unavoidable_moves("IF[#1EQ1]GOTO5\nX1.\nN5#3000=1\n"), IsEmpty());
    EXPECT_THAT(unavoidable_moves("X1.\n#3000=1\n"), ElementsAre("X1."));
    EXPECT_THAT(unavoidable_moves("N1X1.\nGOTO1\n"), IsEmpty()); // nothing ends it
}

} // namespace
} // namespace maclint
