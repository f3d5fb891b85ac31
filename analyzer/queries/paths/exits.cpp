//! Finds exits, their text and what leads to them.
#include "analyzer/queries/paths/exits.hpp"

#include "analyzer/flow/walk.hpp"

#include <algorithm>
#include <variant>

namespace maclint::queries {

Span span_of_exit(const ProgramAnalysis& analysis, const flow::Exit& exit) {
    return exit.effect ? analysis.program().effects[*exit.effect].span
                       : analysis.graph().nodes[exit.node].part;
}

std::optional<Span> last_move_before(const ProgramAnalysis& analysis, const flow::Exit& exit) {
    const Program& program = analysis.program();
    const auto moves = [&](const Effect& effect) { return std::holds_alternative<Motion>(effect.what); };
    for (flow::NodeId id = exit.node + 1; id-- > 0;) {
        const flow::Node& node = analysis.graph().nodes[id];
        const auto effects = program.effects_in(node.effects);
        const auto move = std::ranges::find_if(effects, moves);
        if (move != effects.end()) return move->span;
        if (!node.is_run) continue;
        std::optional<Span> last;
        for_each_block(program, node.stretch(), [&](const BlockView& block) {
            if (block.moves)
                last = Span{block.number ? block.number_span.end : block.span.begin, block.span.end};
        });
        if (last) return last;
    }
    return std::nullopt;
}

Span last_block_before(const ProgramAnalysis& analysis, const flow::Exit& exit, const BlockView& last) {
    const flow::Node& node = analysis.graph().nodes[exit.node];
    if (!node.is_run) return node.part.empty() ? last.span : node.part;
    Span span;
    for_each_block(analysis.program(), node.stretch(), [&](const BlockView& block) { span = block.span; });
    return span;
}

bool is_on_every_path(const ProgramAnalysis& analysis, flow::NodeId node) {
    const auto leaves = [&](flow::NodeId at) {
        return std::ranges::any_of(analysis.graph().exits_at(at),
                                   [](const flow::Exit& exit) { return exit.kind != flow::ExitKind::alarm; });
    };
    if (node == 0) return true;
    bool left = leaves(0);
    flow::walk<flow::Direction::forward>(analysis.graph(), {0}, [&](flow::EdgeId edge, flow::NodeId to) {
        if (left || to == node || !analysis.data().passable(edge)) return flow::Step::refuse;
        left = leaves(to);
        return flow::Step::go_on;
    });
    return !left;
}

namespace {

std::span<const Effect> effects_at(const ProgramAnalysis& analysis, flow::NodeId node) {
    return analysis.program().effects_in(analysis.graph().nodes[node].effects);
}

bool holds_call(const ProgramAnalysis& analysis, flow::NodeId node) {
    return std::ranges::any_of(effects_at(analysis, node), [](const Effect& effect) {
        return std::holds_alternative<Call>(effect.what);
    });
}

bool nothing_follows(const ProgramAnalysis& analysis, flow::NodeId node) {
    return std::ranges::none_of(analysis.graph().out[node],
                                [&](flow::EdgeId edge) { return analysis.data().passable(edge); });
}

} // namespace

std::optional<flow::NodeId> only_successor(const ProgramAnalysis& analysis, flow::NodeId node,
                                           std::optional<bool> side) {
    std::optional<flow::NodeId> next;
    for (const flow::EdgeId id : analysis.graph().out[node]) {
        const flow::Edge& edge = analysis.graph().edges[id];
        if (!analysis.data().passable(id)) continue;
        if (edge.condition && !side) return std::nullopt;
        if (edge.condition && edge.holds != *side) continue;
        if (next) return std::nullopt;
        next = edge.to;
    }
    return next;
}

bool ends_in_alarm(const ProgramAnalysis& analysis, flow::NodeId test, bool side) {
    constexpr int most_nodes = 16;
    flow::NodeId node = test;
    for (int i = 0; i < most_nodes; ++i) {
        const auto next = only_successor(analysis, node, i == 0 ? std::optional(side) : std::nullopt);
        if (!next) return i > 0 && nothing_follows(analysis, node) && holds_call(analysis, node);
        node = *next;
        for (const Effect& effect : effects_at(analysis, node))
            if (const auto* stop = std::get_if<Stop>(&effect.what)) return stop->kind == Stop::Kind::alarm;
    }
    return false;
}

} // namespace maclint::queries
