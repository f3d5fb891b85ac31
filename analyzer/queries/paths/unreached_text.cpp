//! The flow graph says which blocks are reached.
#include "analyzer/queries/paths/unreached_text.hpp"

#include "analyzer/dialect/characters.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>
#include <variant>

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
struct Region {
    Span text;
    std::optional<EffectId> ender; ///< the last effect before them
};

Region region_around(const flow::Graph& graph, Nodes nodes) {
    while (nodes.first > 0 && !is_reached(graph, nodes.first - 1)) --nodes.first;
    while (nodes.end < graph.nodes.size() && !is_reached(graph, nodes.end)) ++nodes.end;
    Region region{{graph.nodes[nodes.first].part.begin, graph.nodes[nodes.end - 1].part.end}, {}};
    if (nodes.first > 0) {
        const Slice effects = graph.nodes[nodes.first - 1].effects;
        if (effects.count != 0) region.ender = effects.first + effects.count - 1;
    }
    return region;
}

bool is_lost(const ProgramAnalysis& analysis, EffectId effect) {
    const auto& jumps = analysis.graph().jumps;
    const auto jump = std::ranges::find(jumps, effect, &flow::ResolvedJump::jump);
    return jump != jumps.end() && jump->label && !jump->target;
}

/// Whether text between them is read by nobody: behind the end of a program, and behind a jump with a remark,
/// `GOTO4(DELETE TO ENABLE)`.
bool is_passed_on_purpose(const ProgramAnalysis& analysis, EffectId ender) {
    const Effect& effect = analysis.program().effects[ender];
    if (const auto* stop = std::get_if<Stop>(&effect.what)) return stop->kind != Stop::Kind::alarm;
    if (!std::holds_alternative<Jump>(effect.what)) return true;
    const auto node = analysis.graph().node_of(ender);
    const Span behind{effect.span.end, node ? analysis.graph().nodes[*node].part.end : effect.span.end};
    return std::ranges::any_of(analysis.program().slice(behind), is_letter);
}

/// Whether one letter or figure was left out, doubled or mistaken for another in such a syntax error.
bool is_slip(const SyntaxError& error) {
    switch (error.kind) {
    case SyntaxErrorKind::bracket_mismatch:
    case SyntaxErrorKind::parenthesis_as_bracket:
    case SyntaxErrorKind::bracket_depth:
    case SyntaxErrorKind::symbolic_comparison:
    case SyntaxErrorKind::letter_o:
    case SyntaxErrorKind::missing_value:
    case SyntaxErrorKind::double_sharp:
    case SyntaxErrorKind::sign_after_sign:
    case SyntaxErrorKind::point_in_variable_number:
    case SyntaxErrorKind::letter_in_jump:
    case SyntaxErrorKind::condition_without_brackets:
    case SyntaxErrorKind::consequence_without_then:
    case SyntaxErrorKind::logic_outside_brackets:
    case SyntaxErrorKind::function_without_brackets:
    case SyntaxErrorKind::assignment_in_condition:
    case SyntaxErrorKind::comparison_as_assignment: return true;
    case SyntaxErrorKind::unknown_keyword: return !error.cure.empty();
    default: return false;
    }
}

/// Whether the block calculates, or gives addresses numbers; prose does neither.
bool reads_as_program(std::string_view block, bool was_to_run) {
    if (block.find_first_of("#[") != std::string_view::npos) return true;
    if (!was_to_run) return false;
    const auto gives_number = [](char address, char figure) {
        return is_letter(address) && is_digit(figure);
    };
    return std::ranges::adjacent_find(block, gives_number) != block.end();
}

} // namespace

std::vector<UnreachedText> unreached_text(const ProgramAnalysis& analysis) {
    std::vector<UnreachedText> found;
    Region region;
    for (const SyntaxError& error : analysis.file().syntax_errors_in(analysis.program().span)) {
        if (error.fault == faults::no_program_number) continue; // another program was to begin there
        const auto nodes = unreached_at(analysis.graph(), error.span.begin);
        if (!nodes) continue;
        const bool in_same = !found.empty() && found.back().region.contains(error.span.begin);
        if (!in_same) region = region_around(analysis.graph(), *nodes);
        UnreachedText text{&error, analysis.graph().nodes[nodes->first].part, region.text, false, {}};
        if (region.ender && is_lost(analysis, *region.ender)) text.lost_jump = region.ender;
        text.is_program_text =
            region.ender && (is_slip(error) || !exemptions::text_that_is_no_slip.is_on()) &&
            (text.lost_jump || !exemptions::text_left_out.is_on() ||
             !is_passed_on_purpose(analysis, *region.ender)) &&
            (!exemptions::text_that_is_prose.is_on() ||
             reads_as_program(analysis.program().slice(text.block), text.lost_jump.has_value()));
        found.push_back(text);
    }
    return found;
}

} // namespace maclint::queries
