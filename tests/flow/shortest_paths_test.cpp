//! Searches in a graph find a shortest path or say that there is none.
#include "analyzer/flow/shortest_paths.hpp"
#include "tests/support/analysed.hpp"
#include "tests/support/dice.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::flow {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using MaybePath = std::optional<std::vector<EdgeId>>;

Graph graph_of(std::size_t nodes, const std::vector<std::pair<NodeId, NodeId>>& edges) {
    Graph graph;
    graph.nodes.resize(nodes);
    for (const auto& [from, to] : edges) graph.edges.push_back({from, to, EdgeKind::next, {}, true, {}, {}});
    graph.out = EdgesByNode(nodes, graph.edges, &Edge::from);
    graph.in = EdgesByNode(nodes, graph.edges, &Edge::to);
    return graph;
}

MaybePath over(std::vector<EdgeId> edges) { return edges; }

bool every(EdgeId) { return true; }

constexpr std::size_t no_limit = 1'000'000;
constexpr std::size_t unreachable = 1'000'000;

/// How many edges lead from one node to every other, by the book: shorter paths are taken until there are
/// none.
std::vector<std::size_t> distances(const Graph& graph, NodeId from, const std::vector<bool>& usable) {
    std::vector<std::size_t> far(graph.nodes.size(), unreachable);
    far[from] = 0;
    for (std::size_t round = 0; round < graph.nodes.size(); ++round)
        for (EdgeId id = 0; id < graph.edges.size(); ++id)
            if (usable[id])
                far[graph.edges[id].to] = std::min(far[graph.edges[id].to], far[graph.edges[id].from] + 1);
    return far;
}

/// The edges follow each other from one node to the other, and all may be used.
bool leads(const Graph& graph, const std::vector<EdgeId>& path, NodeId from, NodeId to,
           const std::vector<bool>& usable) {
    NodeId at = from;
    for (const EdgeId id : path) {
        if (!usable[id] || graph.edges[id].from != at) return false;
        at = graph.edges[id].to;
    }
    return at == to;
}

TEST(EdgesAtNodes, AreInTheOrderOfTheirNumbers) {
    const Graph graph = graph_of(4, {{2, 0}, {0, 2}, {2, 3}, {0, 3}, {2, 2}});
    EXPECT_THAT(graph.out[0], ElementsAre(1, 3));
    EXPECT_THAT(graph.out[1], IsEmpty());
    EXPECT_THAT(graph.out[2], ElementsAre(0, 2, 4));
    EXPECT_THAT(graph.out[3], IsEmpty());
    EXPECT_THAT(graph.in[0], ElementsAre(0));
    EXPECT_THAT(graph.in[1], IsEmpty());
    EXPECT_THAT(graph.in[2], ElementsAre(1, 4));
    EXPECT_THAT(graph.in[3], ElementsAre(2, 3));
}

TEST(ShortestPaths, TakeTheFewestEdges) {
    // 0 to 3 over 1 and 2, or over 4.
    const Graph graph = graph_of(6, {{0, 1}, {1, 2}, {2, 3}, {0, 4}, {4, 3}, {3, 0}});
    const ShortestPaths paths(graph, every);
    EXPECT_EQ(paths.to(graph, 0), over({}));
    EXPECT_EQ(paths.to(graph, 2), over({0, 1}));
    EXPECT_EQ(paths.to(graph, 3), over({3, 4}));
    EXPECT_EQ(paths.to(graph, 5), std::nullopt);
    const ShortestPaths without(graph, [](EdgeId id) { return id != 4; });
    EXPECT_EQ(without.to(graph, 3), over({0, 1, 2}));
    const ShortestPaths closed(graph, [](EdgeId id) { return id != 4 && id != 1; });
    EXPECT_EQ(closed.to(graph, 3), std::nullopt);
}

TEST(Path, OfANodeToItselfIsACycle) {
    const Graph graph = graph_of(4, {{0, 1}, {1, 2}, {2, 1}, {3, 3}});
    EXPECT_EQ(graph.path(1, 1, every, no_limit), over({1, 2}));
    EXPECT_EQ(graph.path(3, 3, every, no_limit), over({3}));
    EXPECT_EQ(graph.path(0, 0, every, no_limit), std::nullopt);
}

TEST(Path, IsNotSearchedForBeyondTheNodesAllowed) {
    const Graph chain = graph_of(5, {{0, 1}, {1, 2}, {2, 3}, {3, 4}});
    EXPECT_EQ(chain.path(0, 4, every, 4), over({0, 1, 2, 3}));
    EXPECT_EQ(chain.path(0, 4, every, 3), std::nullopt);
    EXPECT_EQ(chain.path(0, 3, every, 3), over({0, 1, 2}));
}

TEST(Paths, AreTheShortestInAnyGraph) {
    test::Dice dice(1);
    for (int turn = 0; turn < 200; ++turn) {
        const auto nodes = static_cast<NodeId>(dice.between(1, 12));
        std::vector<std::pair<NodeId, NodeId>> edges;
        std::vector<bool> usable;
        for (std::size_t i = dice.below(30); i > 0; --i) {
            const auto from = static_cast<NodeId>(dice.below(nodes));
            edges.emplace_back(from, static_cast<NodeId>(dice.below(nodes)));
            usable.push_back(!dice.one_in(5));
        }
        const Graph graph = graph_of(nodes, edges);
        const auto may_use = [&](EdgeId id) { return usable[id]; };
        const ShortestPaths from_start(graph, may_use);
        for (NodeId from = 0; from < nodes; ++from) {
            const auto far = distances(graph, from, usable);
            for (NodeId to = 0; to < nodes; ++to) {
                std::vector<MaybePath> paths;
                if (from != to) paths.push_back(graph.path(from, to, may_use, no_limit));
                if (from == 0) paths.push_back(from_start.to(graph, to));
                for (const MaybePath& path : paths) {
                    ASSERT_EQ(path.has_value(), far[to] < unreachable);
                    if (!path) continue;
                    EXPECT_EQ(path->size(), far[to]);
                    EXPECT_TRUE(leads(graph, *path, from, to, usable));
                }
            }
        }
    }
}

TEST(Path, IsFoundThroughManyNodes) {
    constexpr NodeId nodes = 5'000;
    std::vector<std::pair<NodeId, NodeId>> edges;
    for (NodeId node = 1; node < nodes; ++node) edges.emplace_back(node - 1, node);
    const Graph chain = graph_of(nodes, edges);
    EXPECT_EQ(chain.path(0, nodes - 1, every, no_limit).value().size(), nodes - 1);
    EXPECT_EQ(chain.path(nodes - 1, 0, every, no_limit), std::nullopt);
}

/// Places in the order in which the blocks are looked at, by node.
std::vector<std::uint32_t> order_in(const std::string& text) {
    return test::analyse_fanuc(text)->programs().front().graph().order;
}

TEST(Order, ANodeComesAfterThoseThatLeadToItExceptFromTheEndOfALoop) {
    EXPECT_THAT(order_in("#1=1\n#2=2\nM30\n"), ElementsAre(0, 1, 2));
    EXPECT_THAT(order_in("GOTO9\n#1=5\nN9M30\n"), ElementsAre(0, Graph::no_order, 1));
    const auto workspace = test::analyse_fanuc("IF[#1EQ1]GOTO5\nWHILE[#2LT9]DO1\n#2=#2+1\nEND1\n"
                                               "N5IF[#3EQ1]THEN#4=1\n/#5=1\nM30\n");
    const Graph& graph = workspace->programs().front().graph();
    for (const Edge& edge : graph.edges)
        EXPECT_EQ(graph.order[edge.from] < graph.order[edge.to], edge.kind != EdgeKind::back);
    std::vector<std::uint32_t> places = graph.order; // each is taken once, the first by the first node
    EXPECT_EQ(places.front(), 0U);
    std::ranges::sort(places);
    for (std::size_t i = 0; i < places.size(); ++i) EXPECT_EQ(places[i], i);
}

} // namespace
} // namespace maclint::flow
