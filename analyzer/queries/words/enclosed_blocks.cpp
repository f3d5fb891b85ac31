//! Reads plain blocks again where they may be meant.
#include "analyzer/queries/words/enclosed_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace maclint::queries {
namespace {

struct OneNumber {
    std::int64_t number;
    bool operator()(std::int64_t other) const { return other == number; }
    [[nodiscard]] bool between(std::int64_t lowest, std::int64_t highest) const {
        return lowest <= number && number <= highest;
    }
};

Span span_of(const Item& item) {
    return std::visit([](const auto& one) { return one.span; }, item);
}

/// Of those that the part meets; items stand in the order of the text.
Slice items_in(const Program& program, Span part) {
    const auto first = std::ranges::partition_point(
        program.items, [&](const Item& item) { return span_of(item).end <= part.begin; });
    const auto last = std::partition_point(first, program.items.end(),
                                           [&](const Item& item) { return span_of(item).begin < part.end; });
    return {static_cast<Id>(first - program.items.begin()), static_cast<Id>(last - first)};
}

} // namespace

std::vector<Span> blocks_numbered(const Program& program, std::int64_t number) {
    std::vector<Span> places;
    for (const Section& section : program.sections)
        for_each_numbered_block(program, section, OneNumber{number},
                                [&](const BlockView& block) { places.push_back(block.span); });
    return places;
}

std::optional<std::int64_t> block_number(const Word& word) {
    constexpr double most = 1e9;
    const auto* value = std::get_if<Literal>(&word.value);
    if (value == nullptr || value->value < 0 || value->value > most ||
        value->value != std::floor(value->value))
        return std::nullopt;
    return static_cast<std::int64_t>(value->value);
}

void for_each_block_in(const Program& program, Span part,
                       const std::function<void(const BlockView&, std::span<const Word>)>& visit) {
    for_each_block_with_words(
        program, items_in(program, part),
        [&](const PlainRun& run, const auto& take) {
            // Whole blocks: one that is cut off would be another.
            const std::size_t line_end =
                std::min(program.text.find_first_of("\r\n", part.end), program.text.size());
            const Span common{std::max(run.span.begin, part.begin),
                              std::min(run.span.end, static_cast<Offset>(line_end))};
            if (common.begin < common.end) take(common);
        },
        [](const WordSummary&) { return true; },
        [&](const BlockView& block, std::span<const Word> words, const WordSummary*) {
            if (block.span.begin >= part.begin && block.span.begin < part.end) visit(block, words);
        });
}

std::optional<Span> first_statement_in(const Program& program, Span part) {
    const auto stores = [](const Effect& effect) { return std::holds_alternative<Assign>(effect.what); };
    const Slice items = items_in(program, part);
    for (Id i = items.first; i < items.first + items.count; ++i) {
        const auto* block = std::get_if<Block>(&program.items[i]);
        if (block != nullptr && block->words.count == 0 &&
            !std::ranges::all_of(program.effects_in(block->effects), stores))
            return block->span;
    }
    return std::nullopt;
}

} // namespace maclint::queries
