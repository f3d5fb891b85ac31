//! The flow graph says which blocks are reached.
#include "analyzer/queries/unreached_text.hpp"

#include <algorithm>

namespace maclint::queries {
namespace {

bool is_reached(const flow::Graph& graph, std::size_t node) {
    return graph.order[node] != flow::Graph::no_order;
}

/// The blocks in a row that nothing reaches and that hold the place; empty where something reaches it.
Span region_around(const flow::Graph& graph, Offset place) {
    // Several nodes may stand in one block: all of them have to be out of reach.
    const auto& nodes = graph.nodes;
    const auto after =
        std::ranges::upper_bound(nodes, place, {}, [](const flow::Node& node) { return node.part.begin; });
    auto first = static_cast<std::size_t>(after - nodes.begin());
    auto last = first;
    while (first > 0 && nodes[first - 1].part.contains(place)) --first;
    if (first == last) return {place, place};
    for (std::size_t i = first; i < last; ++i)
        if (is_reached(graph, i)) return {place, place};
    while (first > 0 && !is_reached(graph, first - 1)) --first;
    while (last < nodes.size() && !is_reached(graph, last)) ++last;
    return {nodes[first].part.begin, nodes[last - 1].part.end};
}

} // namespace

std::vector<UnreachedText> unreached_text(const ProgramAnalysis& analysis) {
    std::vector<UnreachedText> found;
    for (const SyntaxError& error : analysis.file().syntax_errors) {
        if (!analysis.program().span.contains(error.span.begin)) continue;
        const Span region = region_around(analysis.graph(), error.span.begin);
        if (!region.empty()) found.push_back({&error, region});
    }
    return found;
}

} // namespace maclint::queries
