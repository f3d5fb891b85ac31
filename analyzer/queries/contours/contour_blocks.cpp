//! Looks a number up, and reads its block.
#include "analyzer/queries/contours/contour_blocks.hpp"

#include "analyzer/program/item_at.hpp"
#include "analyzer/program/whole_number.hpp"

#include <algorithm>

namespace maclint::queries {

std::optional<NumberedBlock> find_contour_block(const ProgramFile& file, double number) {
    const auto whole = whole_number(number);
    if (!whole) return std::nullopt;
    std::optional<NumberedBlock> found;
    for (const NumberedBlock& block : find_blocks(file, {*whole})) {
        if (block.section == nullptr || block.section->role != SectionKind::Role::contour) continue;
        if (found) return std::nullopt;
        found = block;
    }
    return found;
}

void read_block(const NumberedBlock& block,
                const std::function<void(const BlockView&, std::span<const Word>)>& visit) {
    const Program& program = *block.program;
    const Slice all{0, static_cast<Id>(program.items.size())};
    const ItemId first = item_at(program, all, block.number_span.begin);
    if (first == program.items.size()) return;
    const Span item = program.span_of(first);
    const std::size_t line_end = program.text.find_first_of("\r\n", block.number_span.begin);
    const Span part{std::max(item.begin, block.number_span.begin),
                    static_cast<Offset>(std::min<std::size_t>(line_end, item.end))};
    for_each_block_with_words(
        program, Stretch{first, std::holds_alternative<Block>(program.items[first]) ? item : part},
        [&](const BlockView& view, std::span<const Word> words) {
            if (view.number_span.begin == block.number_span.begin) visit(view, words);
        });
}

} // namespace maclint::queries
