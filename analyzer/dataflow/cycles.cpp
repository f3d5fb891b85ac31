//! Strongly connected components of the part that can be run.
#include "analyzer/dataflow/cycles.hpp"

namespace maclint::dataflow {

bool leads_back(const flow::Graph& graph, const Analysis& analysis, flow::EdgeId edge) {
    const flow::Edge& e = graph.edges[edge];
    return graph.order[e.to] <= graph.order[e.from] && analysis.passable(edge);
}

flow::Adjacency adjacency_along(const flow::Graph& graph, const Analysis& analysis) {
    flow::Adjacency adjacency;
    adjacency.reserve(graph.nodes.size(), graph.edges.size());
    for (flow::NodeId node = 0; node < graph.nodes.size(); ++node) {
        for (const flow::EdgeId id : graph.out[node])
            if (analysis.passable(id)) adjacency.add(graph.edges[id].to);
        adjacency.end_list();
    }
    return adjacency;
}

std::optional<Cycles> find_cycles(const flow::Graph& graph, const Analysis& analysis) {
    bool any = false;
    for (flow::EdgeId edge = 0; edge < graph.edges.size() && !any; ++edge)
        any = leads_back(graph, analysis, edge);
    if (!any) return std::nullopt;
    Cycles cycles{adjacency_along(graph, analysis), {}};
    cycles.components = flow::find_components(cycles.adjacency);
    return cycles;
}

} // namespace maclint::dataflow
