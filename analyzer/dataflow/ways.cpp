//! Searches for a way around every assignment.
#include "analyzer/dataflow/ways.hpp"

#include <algorithm>
#include <vector>

namespace maclint::dataflow {

bool assigned_on_every_way(const flow::Graph& graph, const Analysis& analysis, Place place,
                           flow::NodeId node) {
    std::vector<flow::NodeId> assigning;
    for (const Store& store : analysis.facts().stores)
        if (store.place == place && store.node != node) assigning.push_back(store.node);
    const auto assigns = [&](flow::NodeId n) { return std::ranges::binary_search(assigning, n); };
    if (assigning.empty() || node == 0) return false;
    if (assigns(0)) return true;
    return !graph.way(0, node, [&](flow::EdgeId edge) {
        return analysis.passable(edge) && !assigns(graph.edges[edge].to);
    });
}

} // namespace maclint::dataflow
