//! Walks along paths, and back from their ends.
#include "analyzer/queries/paths/path_steps.hpp"

#include <algorithm>
#include <ranges>
#include <variant>

namespace maclint::queries {
namespace {

/// A path is for a reader: many findings must not cost many searches of a whole long program.
constexpr std::size_t most_searched = 4096;
constexpr std::size_t most_looked_at = 256;

/// The nodes from which the end can be reached. Where too many would be looked at, all are taken for such.
std::vector<bool> leading_to(const ProgramAnalysis& analysis, flow::NodeId end) {
    const flow::Graph& graph = analysis.graph();
    std::vector<bool> leads(graph.nodes.size(), false);
    std::vector<flow::NodeId> stack{end};
    leads[end] = true;
    std::size_t looked_at = 0;
    while (!stack.empty()) {
        if (++looked_at > most_looked_at) return std::vector<bool>(graph.nodes.size(), true);
        const flow::NodeId node = stack.back();
        stack.pop_back();
        for (const flow::EdgeId id : graph.in[node]) {
            const flow::NodeId from = graph.edges[id].from;
            if (leads[from] || !analysis.data().passable(id)) continue;
            leads[from] = true;
            stack.push_back(from);
        }
    }
    return leads;
}

/// Whether the other side of a branch would have led there, too.
bool has_choice(const ProgramAnalysis& analysis, flow::EdgeId taken, const std::vector<bool>& leads) {
    const flow::Graph& graph = analysis.graph();
    return std::ranges::any_of(graph.out[graph.edges[taken].from], [&](flow::EdgeId id) {
        return id != taken && analysis.data().passable(id) && leads[graph.edges[id].to];
    });
}

bool repeats_by_a_word(const ProgramAnalysis& analysis, const flow::Edge& edge) {
    if (!edge.condition) return false;
    const Program& program = analysis.program();
    const Span condition = program.expressions[*edge.condition].span;
    return std::ranges::any_of(
        program.effects_in(analysis.graph().nodes[edge.from].effects), [&](const Effect& effect) {
            return effect.span == condition && std::holds_alternative<Guarded>(effect.what);
        });
}

} // namespace

std::optional<std::vector<flow::EdgeId>> shortest_path(const ProgramAnalysis& analysis, flow::NodeId from,
                                                       flow::NodeId to) {
    if (from == 0) return analysis.path_from_start(to);
    const auto passable = [&](flow::EdgeId edge) { return analysis.data().passable(edge); };
    return analysis.graph().path(from, to, passable, most_searched);
}

std::vector<flow::EdgeId> telling_steps(const ProgramAnalysis& analysis, std::span<const flow::EdgeId> path,
                                        std::size_t most) {
    std::vector<flow::EdgeId> steps;
    if (path.empty()) return steps;
    const flow::Graph& graph = analysis.graph();
    const std::vector<bool> leads = leading_to(analysis, graph.edges[path.back()].to);
    // The last steps say most; a path may have thousands.
    for (const flow::EdgeId id : path | std::views::reverse) {
        if (steps.size() == most) break;
        const flow::EdgeKind kind = graph.edges[id].kind;
        if (kind == flow::EdgeKind::next) continue;
        if (kind == flow::EdgeKind::branch && !has_choice(analysis, id, leads)) continue;
        steps.push_back(id);
    }
    std::ranges::reverse(steps);
    return steps;
}

Span span_of_step(const ProgramAnalysis& analysis, flow::EdgeId step) {
    const flow::Edge& edge = analysis.graph().edges[step];
    if (edge.condition) return analysis.program().expressions[*edge.condition].span;
    if (edge.jump) return analysis.program().effects[*edge.jump].span;
    const auto& nodes = analysis.graph().nodes;
    const flow::NodeId behind = edge.from + 1; // nodes of blocks stand in the order of the text
    if (edge.kind == flow::EdgeKind::skip && behind < nodes.size() &&
        nodes[behind].part.begin >= nodes[edge.from].part.end)
        return nodes[behind].part;
    return nodes[edge.from].part;
}

std::string_view outcome_of(const ProgramAnalysis& analysis, const flow::Edge& edge) {
    if (repeats_by_a_word(analysis, edge)) return edge.holds ? "once more" : "the program goes on";
    return edge.holds ? "true" : "false";
}

} // namespace maclint::queries
