//! An edge into a skipped block runs it; one from before it to behind it passes it by.
#include "analyzer/execution/skips.hpp"

#include "analyzer/program/block_view.hpp"

#include <algorithm>
#include <bit>
#include <variant>

namespace maclint::execution {
namespace {

/// The levels of the block, where the node stands for its text. A node in front of a block, to which jumps
/// lead, has none.
std::uint16_t levels_of(const Program& program, const flow::Node& node) {
    const auto block = stored_block(program, node.item);
    return !block || node.part.empty() ? std::uint16_t{0} : block->skip_levels;
}

std::uint16_t one_alone(std::uint16_t levels) {
    return std::has_single_bit(levels) ? levels : std::uint16_t{0};
}

/// Whether the node ends in the mark of a loop or choice, from which edges lead past others of its parts.
bool is_mark(const Program& program, const flow::Node& node) {
    const auto effects = program.effects_in(node.effects);
    return !effects.empty() && std::holds_alternative<RegionMark>(effects.back().what);
}

bool is_part_of(const flow::Node& node, const flow::Node& of) {
    return node.item == of.item && node.part == of.part;
}

/// Whether the edge leads on in the text and passes by skipped blocks alone, if any; adds their levels.
bool passes_by(const Program& program, const flow::Graph& graph, const flow::Edge& edge,
               std::uint16_t& levels) {
    const bool leads_on = edge.kind == flow::EdgeKind::next || edge.kind == flow::EdgeKind::skip ||
                          edge.kind == flow::EdgeKind::branch;
    if (!leads_on || edge.to <= edge.from || is_mark(program, graph.nodes[edge.from])) return false;
    for (flow::NodeId node = edge.from + 1; node < edge.to; ++node) {
        if (is_part_of(graph.nodes[node], graph.nodes[edge.from])) continue;
        const std::uint16_t skipped = levels_of(program, graph.nodes[node]);
        if (skipped == 0) return false;
        levels |= one_alone(skipped);
    }
    return true;
}

Switches switches_at(const Program& program, const flow::Graph& graph, const flow::Edge& edge) {
    Switches switches;
    const flow::Node& to = graph.nodes[edge.to];
    if (!is_part_of(graph.nodes[edge.from], to)) switches.off = one_alone(levels_of(program, to));
    std::uint16_t passed = 0;
    if (passes_by(program, graph, edge, passed)) switches.on = passed;
    return switches;
}

} // namespace

Skips::Skips(const Program& program, const flow::Graph& graph) {
    const bool any = std::ranges::any_of(
        graph.nodes, [&](const flow::Node& node) { return levels_of(program, node) != 0; });
    if (!any) return;
    switches_.reserve(graph.edges.size());
    for (const flow::Edge& edge : graph.edges) switches_.push_back(switches_at(program, graph, edge));
}

} // namespace maclint::execution
