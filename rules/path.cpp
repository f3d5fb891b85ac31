//! Puts paths through the flow graph into words.
#include "rules/path.hpp"

#include "analyzer/program/block_view.hpp"
#include "analyzer/source/encoding.hpp"

#include <algorithm>
#include <cstddef>
#include <ranges>

namespace maclint {
namespace {

/// A path is for a reader: many findings must not cost many searches of a whole long program.
constexpr std::size_t most_searched = 4096;
constexpr std::size_t most_steps = 12;
constexpr std::size_t most_looked_at = 256;
constexpr std::size_t longest_quote = 40;

Span span_of(const Program& program, const flow::Edge& edge, const flow::Graph& graph) {
    if (edge.condition) return program.expressions[*edge.condition].span;
    if (edge.jump) return program.effects[*edge.jump].span;
    return graph.nodes[edge.from].part;
}

/// What a step along the edge means to a reader; empty for the next block.
std::string words_for(const ProgramAnalysis& analysis, const flow::Edge& edge) {
    const Program& program = analysis.program();
    switch (edge.kind) {
    case flow::EdgeKind::next: return {};
    case flow::EdgeKind::branch:
        return "the condition '" + quoted(program, program.expressions[*edge.condition].span) +
               (edge.holds ? "' is true here" : "' is not true here");
    case flow::EdgeKind::jump:
    case flow::EdgeKind::computed:
        return "jumps to line " + line_number(analysis.file(), analysis.graph().nodes[edge.to].part.begin);
    case flow::EdgeKind::back: return "the loop starts again";
    case flow::EdgeKind::pass: return "the other channels go on";
    case flow::EdgeKind::skip: return "the block is skipped when its switch is on";
    case flow::EdgeKind::resume:
        return "the called program returns to line " +
               line_number(analysis.file(), analysis.graph().nodes[edge.to].part.begin);
    }
    return {};
}

/// The last block of a plain run's part that sets the group.
Span last_setting(const Program& program, const flow::Node& node, GroupId group) {
    Span found = node.part;
    for_each_block(program, node.stretch(), [&](const BlockView& block) {
        for (const ModalSetting& setting : block.settings)
            if (setting.group == group) found = block.span;
    });
    return found;
}

Span span_of(const ProgramAnalysis& analysis, const dataflow::Origin& origin) {
    const Program& program = analysis.program();
    switch (origin.kind) {
    case dataflow::Origin::Kind::effect: return program.effects[origin.id].span;
    case dataflow::Origin::Kind::expression: return program.expressions[origin.id].span;
    case dataflow::Origin::Kind::run:
        return last_setting(program, analysis.graph().nodes[origin.node], static_cast<GroupId>(origin.id));
    case dataflow::Origin::Kind::entry:
    case dataflow::Origin::Kind::none: break;
    }
    return program.name_span.begin != program.name_span.end ? program.name_span
                                                            : analysis.graph().nodes[0].part;
}

/// The nodes from which the end can be reached. So many are looked at; of those beyond, it is taken for
/// granted.
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

} // namespace

std::vector<RelatedLocation> steps_along(const ProgramAnalysis& analysis,
                                         std::span<const flow::EdgeId> path) {
    std::vector<RelatedLocation> related;
    if (path.empty()) return related;
    const flow::Graph& graph = analysis.graph();
    const std::vector<bool> leads = leading_to(analysis, graph.edges[path.back()].to);
    // The last steps say most; a path may have thousands.
    for (const flow::EdgeId id : path | std::views::reverse) {
        if (related.size() == most_steps) break;
        const flow::Edge& edge = graph.edges[id];
        if (edge.kind == flow::EdgeKind::branch && !has_choice(analysis, id, leads)) continue;
        std::string words = words_for(analysis, edge);
        if (!words.empty())
            related.push_back(
                {analysis.source(), span_of(analysis.program(), edge, graph), std::move(words)});
    }
    std::ranges::reverse(related);
    return related;
}

std::vector<RelatedLocation> path_between(const ProgramAnalysis& analysis, flow::NodeId from,
                                          flow::NodeId to) {
    const auto passable = [&](flow::EdgeId edge) { return analysis.data().passable(edge); };
    const auto path =
        from == 0 ? analysis.path_from_start(to) : analysis.graph().path(from, to, passable, most_searched);
    return path ? steps_along(analysis, *path) : std::vector<RelatedLocation>{};
}

RelatedLocation related_at(const ProgramAnalysis& analysis, dataflow::OriginId origin, std::string text) {
    return {analysis.source(), span_of(analysis, analysis.data().origin(origin)), std::move(text)};
}

RelatedLocation related_at_effect(const ProgramAnalysis& analysis, EffectId effect, std::string text) {
    return {analysis.source(), analysis.program().effects[effect].span, std::move(text)};
}

Cause cause_at(const ProgramAnalysis& analysis, dataflow::OriginId origin) {
    const dataflow::Origin& from = analysis.data().origin(origin);
    if (from.kind == dataflow::Origin::Kind::effect) return {analysis, from.id};
    return {analysis, span_of(analysis, from)};
}

std::string quoted(const Program& program, Span span) {
    const std::string_view bytes = program.slice(span);
    const std::string text = to_utf8(bytes, detect_encoding(bytes));
    std::string folded;
    std::size_t characters = 0;
    for (const char c : text) {
        const bool blank = c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\0';
        if (blank && (folded.empty() || folded.back() == ' ')) continue;
        // A byte that does not continue a UTF-8 character begins one.
        const bool begins_character = (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
        if (begins_character && characters++ == longest_quote) return folded + "…";
        folded += blank ? ' ' : c;
    }
    while (!folded.empty() && folded.back() == ' ') folded.pop_back();
    return folded;
}

std::string line_number(const ProgramFile& file, Offset offset) {
    return std::to_string(file.source->position(offset).line);
}

} // namespace maclint
