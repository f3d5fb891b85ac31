//! Looks at the words and effects of one node.
#include "analyzer/queries/machine/skip_moves.hpp"

#include "analyzer/program/block_view.hpp"

#include <algorithm>
#include <variant>

namespace maclint::queries {

std::optional<Span> block_with_code(const ProgramAnalysis& analysis, flow::NodeId node,
                                    std::span<const double> codes) {
    std::optional<Span> found;
    for_each_block_with_words(analysis.program(), analysis.graph().nodes[node].stretch(),
                              [&](const BlockView& block, std::span<const Word> words) {
                                  if (std::ranges::any_of(words, [&](const Word& word) {
                                          const auto* number = std::get_if<Literal>(&word.value);
                                          return word.address == "G" && number != nullptr &&
                                                 std::ranges::find(codes, number->value) != codes.end();
                                      }))
                                      found = block.span;
                              });
    return found;
}

bool has_move(const ProgramAnalysis& analysis, flow::NodeId node) {
    const flow::Node& at = analysis.graph().nodes[node];
    if (std::ranges::any_of(analysis.program().effects_in(at.effects),
                            [](const Effect& effect) { return std::holds_alternative<Motion>(effect.what); }))
        return true;
    bool found = false;
    for_each_block_with_words(analysis.program(), at.stretch(),
                              [&](const BlockView& block, std::span<const Word>) { found |= block.moves; });
    return found;
}

} // namespace maclint::queries
