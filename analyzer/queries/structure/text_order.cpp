//! Keeps the words of each block.
#include "analyzer/queries/structure/text_order.hpp"

#include "analyzer/program/section_blocks.hpp"
#include "analyzer/program/word_lookup.hpp"

#include <algorithm>
#include <variant>

namespace maclint::queries {
namespace {

constexpr std::size_t most_blocks = 5000;

bool breaks(const Program& program, const BlockView& block) {
    return block.skip_levels != 0 ||
           std::ranges::any_of(program.effects_in(block.effects), [](const Effect& effect) {
               return !std::holds_alternative<SetModal>(effect.what) &&
                      !std::holds_alternative<EvaluateWords>(effect.what) &&
                      !std::holds_alternative<Motion>(effect.what) &&
                      !std::holds_alternative<Assign>(effect.what) &&
                      !std::holds_alternative<Synchronise>(effect.what) &&
                      !std::holds_alternative<ToolChange>(effect.what) &&
                      !std::holds_alternative<Reference>(effect.what);
           });
}

} // namespace

std::optional<double> TextBlock::code() const { return number_of(words, "G"); }

std::optional<std::vector<TextBlock>> blocks_in_order(const Program& program, const Section& section) {
    if (plain_blocks(program, section) > most_blocks) return std::nullopt;
    std::vector<TextBlock> blocks;
    for (ItemId item = section.items.first; item < section.items.first + section.items.count; ++item)
        for_each_block_with_words(
            program, Stretch{item, program.span_of(item)},
            [&](const BlockView& block, std::span<const Word> words) {
                blocks.push_back({block, {words.begin(), words.end()}, breaks(program, block)});
            });
    return blocks;
}

} // namespace maclint::queries
