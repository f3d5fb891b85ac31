//! Finds the text of exits.
#include "analyzer/queries/exits.hpp"

namespace maclint::queries {

Span span_of_exit(const ProgramAnalysis& analysis, const flow::Exit& exit) {
    return exit.effect ? analysis.program().effects[*exit.effect].span
                       : analysis.graph().nodes[exit.node].part;
}

Span last_block_before(const ProgramAnalysis& analysis, const flow::Exit& exit, const BlockView& last) {
    const flow::Node& node = analysis.graph().nodes[exit.node];
    if (!node.is_run) return node.part.empty() ? last.span : node.part;
    Span span;
    for_each_block(analysis.program(), node.stretch(), [&](const BlockView& block) { span = block.span; });
    return span;
}

} // namespace maclint::queries
