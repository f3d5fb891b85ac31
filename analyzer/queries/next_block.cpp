//! Reads on from a block.
#include "analyzer/queries/next_block.hpp"

#include "analyzer/workspace/program_analysis.hpp"

#include <algorithm>
#include <charconv>
#include <variant>

namespace maclint::queries {
namespace {

constexpr int most_blocks = 8;

/// Whether the control only sets codes in the block and goes on to the next.
bool sets_codes_alone(const Program& program, const BlockView& block) {
    return !block.moves && block.skip_levels == 0 && !block.name &&
           std::ranges::all_of(program.effects_in(block.effects), [](const Effect& effect) {
               return std::holds_alternative<SetModal>(effect.what);
           });
}

/// Looks at one block after the other until it has found the one, or there is no use in going on.
struct Search {
    const Program& program;
    Offset after;
    char letter;
    int left = most_blocks;
    bool ended = false;
    std::optional<std::vector<Word>> found = {};

    void look_at(const BlockView& block, std::span<const Word> words) {
        if (ended || block.span.begin < after) return;
        if (std::ranges::any_of(
                words, [&](const Word& word) { return word.address == std::string_view(&letter, 1); }))
            found.emplace(words.begin(), words.end());
        ended = found || --left == 0 || !sets_codes_alone(program, block);
    }
};

ItemId item_at(const Program& program, Slice items, Offset place) {
    ItemId first = items.first;
    ItemId last = items.first + items.count;
    while (first < last) {
        const ItemId middle = first + (last - first) / 2;
        if (program.span_of(middle).end <= place)
            first = middle + 1;
        else
            last = middle;
    }
    return first;
}

} // namespace

std::optional<std::vector<Word>> next_block_with(const WordsOfBlock& block, char letter) {
    const Program& program = block.analysis.program();
    const Slice items = block.section.items;
    Search search{program, block.block.span.end, letter};
    for (ItemId item = item_at(program, items, search.after);
         item < items.first + items.count && !search.ended; ++item) {
        const Span span = program.span_of(item);
        const Span part{std::max(span.begin, search.after), span.end};
        for_each_block_with_words(
            program, Stretch{item, part},
            [&](const BlockView& view, std::span<const Word> words) { search.look_at(view, words); });
    }
    return std::move(search.found);
}

bool holds_code(const std::vector<Word>& words, std::string_view codes) {
    return std::ranges::any_of(words, [&](const Word& word) {
        const auto* value = std::get_if<Literal>(&word.value);
        for (std::size_t at = codes.find(word.address); at != std::string_view::npos;
             at = codes.find(word.address, at + 1)) {
            double code = 0;
            std::from_chars(codes.data() + at + word.address.size(), codes.data() + codes.size(), code);
            if (value == nullptr || code == value->value) return true; // a computed one may be any
        }
        return false;
    });
}

} // namespace maclint::queries
