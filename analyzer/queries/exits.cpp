//! Finds the text of exits.
#include "analyzer/queries/exits.hpp"

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

} // namespace maclint::queries
