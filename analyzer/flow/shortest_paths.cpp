//! Breadth first over the whole graph.
#include "analyzer/flow/shortest_paths.hpp"

#include <algorithm>

namespace maclint::flow {

ShortestPaths::ShortestPaths(const Graph& graph, const std::function<bool(EdgeId)>& usable)
    : met_by_(graph.nodes.size(), not_met) {
    std::vector<NodeId> met{0};
    for (std::size_t i = 0; i < met.size(); ++i)
        for (const EdgeId id : graph.out[met[i]]) {
            const NodeId next = graph.edges[id].to;
            if (next == 0 || met_by_[next] != not_met || !usable(id)) continue;
            met_by_[next] = id;
            met.push_back(next);
        }
}

std::optional<std::vector<EdgeId>> ShortestPaths::to(const Graph& graph, NodeId node) const {
    std::vector<EdgeId> path;
    for (; node != 0; node = graph.edges[path.back()].from) {
        if (met_by_[node] == not_met) return std::nullopt;
        path.push_back(met_by_[node]);
    }
    std::ranges::reverse(path);
    return path;
}

} // namespace maclint::flow
