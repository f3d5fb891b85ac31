//! A walk over a graph from some of its nodes, to each other node once, the nearest first.
#pragma once

#include "analyzer/flow/graph.hpp"
#include "analyzer/flow/met_nodes.hpp"
#include "analyzer/flow/solve.hpp"
#include "analyzer/source/budget.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace maclint::flow {

/// What a walk does at an edge to a node that it has not met.
enum class Step : std::uint8_t {
    refuse, ///< does not take the edge; others may lead to the node
    end,    ///< meets the node, and goes no further from there
    go_on,
};

/// Asks `step(edge, node)` of the edges, taken forwards or backwards, from the nodes of `from`, and of those
/// that it goes on from. The nodes of `from` count as not met: a cycle may lead back to them. It ends where
/// the thread's Budget is met.
template<Direction direction, class Ask>
void walk(const Graph& graph, std::vector<NodeId> from, const Ask& step) {
    constexpr bool forward = direction == Direction::forward;
    MetNodes met(graph.nodes.size());
    for (std::size_t next = 0; next < from.size(); ++next) {
        if (!Budget::allows()) return;
        const NodeId at = from[next];
        for (const EdgeId id : forward ? graph.out[at] : graph.in[at]) {
            const NodeId node = forward ? graph.edges[id].to : graph.edges[id].from;
            if (met.contains(node)) continue;
            const Step taken = step(id, node);
            if (taken != Step::refuse) met.insert(node);
            if (taken == Step::go_on) from.push_back(node);
        }
    }
}

} // namespace maclint::flow
