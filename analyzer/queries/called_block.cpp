//! The word stands in the block of the call.
#include "analyzer/queries/called_block.hpp"

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace maclint::queries {

std::optional<std::int64_t> first_block_called(const Program& program, const Effect& call) {
    const CallKind& kind = program.control->calls[std::get<Call>(call.what).kind];
    if (kind.frame != Frame::shared) return std::nullopt;
    const auto ends_before = [&](const Item& item) {
        const auto* run = std::get_if<PlainRun>(&item);
        return (run == nullptr ? std::get<Block>(item).span : run->span).end <= call.span.begin;
    };
    const auto item = std::ranges::partition_point(program.items, ends_before);
    const auto* block = item == program.items.end() ? nullptr : std::get_if<Block>(&*item);
    if (block == nullptr) return std::nullopt;
    for (Id i = block->words.first; i < block->words.first + block->words.count; ++i) {
        const Word& word = program.words[i];
        const auto* value = std::get_if<Literal>(&word.value);
        if (value != nullptr && word.address == "Q" && call.span.contains(word.span.begin))
            return std::llround(value->value);
    }
    return std::nullopt;
}

bool has_block(const Program& program, std::int64_t number) {
    const auto is_it = [&](const BlockView& block) { return block.number == number; };
    return std::ranges::any_of(program.items, [&](const Item& item) {
        const auto* run = std::get_if<PlainRun>(&item);
        if (run != nullptr && (number < run->lowest_number || number > run->highest_number)) return false;
        return !blocks::visit_item(program, item, [&](const BlockView& block) { return !is_it(block); });
    });
}

} // namespace maclint::queries
