//! The flow graph says which blocks are reached.
#include "analyzer/queries/unreached_text.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace maclint::queries {
namespace {

bool is_reached(const flow::Graph& graph, std::size_t node) {
    return graph.order[node] != flow::Graph::no_order;
}

/// Neighbours, by their places in the graph.
struct Nodes {
    std::size_t first, end;
};

/// The nodes of the block at the place; nothing where there is none, or one of them is reached.
std::optional<Nodes> unreached_at(const flow::Graph& graph, Offset place) {
    // Several nodes may stand in one block: all of them have to be out of reach.
    const auto after = std::ranges::upper_bound(graph.nodes, place, {},
                                                [](const flow::Node& node) { return node.part.begin; });
    const auto end = static_cast<std::size_t>(after - graph.nodes.begin());
    std::size_t first = end;
    for (; first > 0 && graph.nodes[first - 1].part.contains(place); --first)
        if (is_reached(graph, first - 1)) return std::nullopt;
    return first == end ? std::nullopt : std::optional(Nodes{first, end});
}

/// The blocks in a row that nothing reaches, around some of them.
Span region_around(const flow::Graph& graph, Nodes nodes) {
    while (nodes.first > 0 && !is_reached(graph, nodes.first - 1)) --nodes.first;
    while (nodes.end < graph.nodes.size() && !is_reached(graph, nodes.end)) ++nodes.end;
    return {graph.nodes[nodes.first].part.begin, graph.nodes[nodes.end - 1].part.end};
}

} // namespace

std::vector<UnreachedText> unreached_text(const ProgramAnalysis& analysis) {
    std::vector<UnreachedText> found;
    for (const SyntaxError& error : analysis.file().syntax_errors_in(analysis.program().span)) {
        const auto nodes = unreached_at(analysis.graph(), error.span.begin);
        if (!nodes) continue;
        const bool in_same = !found.empty() && found.back().region.contains(error.span.begin);
        found.push_back({&error, in_same ? found.back().region : region_around(analysis.graph(), *nodes)});
    }
    return found;
}

} // namespace maclint::queries
