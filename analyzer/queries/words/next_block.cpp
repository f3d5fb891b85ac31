//! Reads on from a block.
#include "analyzer/queries/words/next_block.hpp"

#include "analyzer/program/item_at.hpp"
#include "analyzer/program/lines_with.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <algorithm>
#include <charconv>
#include <variant>

namespace maclint::queries {
namespace {

constexpr int most_blocks = 8;
constexpr int most_later_lines = 200;

/// Whether the control only sets codes in the block and goes on to the next.
bool sets_codes_alone(const Program& program, const BlockView& block) {
    return !block.moves && block.skip_levels == 0 && !block.name &&
           std::ranges::all_of(program.effects_in(block.effects), [](const Effect& effect) {
               return std::holds_alternative<SetModal>(effect.what);
           });
}

std::vector<LetterCodes> letters_of(std::string_view codes) {
    std::vector<LetterCodes> letters;
    for (std::size_t at = 0; at < codes.size(); at = std::min(codes.find(' ', at), codes.size() - 1) + 1) {
        double code = 0;
        std::from_chars(codes.data() + at + 1, codes.data() + codes.size(), code);
        auto of_letter = std::ranges::find(letters, codes[at], &LetterCodes::letter);
        if (of_letter == letters.end()) of_letter = letters.insert(of_letter, {codes[at], {}});
        of_letter->codes.add(code);
    }
    return letters;
}

bool has_letter(std::span<const Word> words, char letter) {
    return std::ranges::any_of(
        words, [&](const Word& word) { return word.address == std::string_view(&letter, 1); });
}

/// The letter as an address that lasts.
std::string_view letter_of(char letter) {
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
    return letters.substr(static_cast<std::size_t>(letter - 'A'), 1);
}

/// Whether the block calls a program, in which any code may stand.
bool calls(const Program& program, const BlockView& block) {
    return std::ranges::any_of(program.effects_in(block.effects), [](const Effect& effect) {
        return std::holds_alternative<Call>(effect.what);
    });
}

/// Looks at one block after the other until it has found the one, or there is no use in going on.
struct NextBlockWithLetter {
    const Program& program;
    Offset after;
    char letter;
    int left = most_blocks;
    bool ended = false;
    std::optional<std::vector<Word>> found = {};

    void look_at(const BlockView& block, std::span<const Word> words) {
        if (ended || block.span.begin < after) return;
        if (has_letter(words, letter)) found.emplace(words.begin(), words.end());
        ended = found || --left == 0 || !sets_codes_alone(program, block);
    }
};

/// Where the line begins that many lines after the place, or the text ends.
Offset lines_on(std::string_view text, Offset place, int lines) {
    std::size_t at = place;
    for (; lines > 0 && at < text.size(); --lines) {
        at = std::min(text.find_first_of("\r\n", at), text.size());
        if (at + 1 < text.size() && text[at] == '\r' && text[at + 1] == '\n') ++at;
        at = std::min(at + 1, text.size());
    }
    return static_cast<Offset>(at);
}

/// `visit(BlockView, words)` for the section's blocks that begin in the part, while `goes_on()`.
template<class GoesOn, class Visit>
void for_each_block_in(const WordsOfBlock& block, Span part, const GoesOn& goes_on, const Visit& visit) {
    constexpr int lines_at_once = 16; // of a run, which may be long
    const Program& program = block.analysis.program();
    const Slice items = block.section.items;
    const auto look = [&](const BlockView& view, std::span<const Word> words) {
        if (view.span.begin >= part.begin && goes_on()) visit(view, words);
    };
    for (ItemId item = item_at(program, items, part.begin); item < items.first + items.count && goes_on();
         ++item) {
        const Span span = program.span_of(item);
        if (span.begin >= part.end) return;
        const bool is_run = std::holds_alternative<PlainRun>(program.items[item]);
        const Offset end = std::min(span.end, part.end);
        for (Offset at = std::max(span.begin, part.begin); at < end && goes_on();) {
            const Offset next = is_run ? std::min(end, lines_on(program.text, at, lines_at_once)) : end;
            for_each_block_with_words(program, Stretch{item, {at, next}}, look);
            at = next;
        }
    }
}

/// Where the line begins that many lines before the place.
Offset lines_back(std::string_view text, Offset place, int lines) {
    std::size_t begin = place;
    for (; lines >= 0 && begin > 0; --lines) {
        const std::size_t end = text.find_last_of("\r\n", begin - 1);
        if (end == std::string_view::npos) return 0;
        begin = end;
    }
    return static_cast<Offset>(begin);
}

} // namespace

std::optional<std::vector<Word>> next_block_with(const WordsOfBlock& block, char letter) {
    const Program& program = block.analysis.program();
    NextBlockWithLetter search{program, block.block.span.end, letter};
    for_each_block_in(
        block, {search.after, static_cast<Offset>(program.text.size())}, [&] { return !search.ended; },
        [&](const BlockView& view, std::span<const Word> words) { search.look_at(view, words); });
    return std::move(search.found);
}

std::optional<std::vector<Word>> last_block_with(const WordsOfBlock& block, char letter) {
    const Program& program = block.analysis.program();
    const Offset place = block.block.span.begin;
    const Slice items = block.section.items;
    const Offset first = items.count == 0 ? place : program.span_of(items.first).begin;
    std::optional<std::vector<Word>> found;
    for (int lines = most_blocks; !found; lines *= 2) {
        const Offset begin = lines_back(program.text, place, lines);
        for_each_block_in(
            block, {begin, place}, [] { return true; },
            [&](const BlockView& view, std::span<const Word> words) {
                if (has_letter(words, letter)) found.emplace(words.begin(), words.end());
                if (calls(program, view)) found = std::vector{Word{letter_of(letter), {}, false, view.span}};
            });
        if (begin <= first) break;
    }
    return found;
}

bool comes_later(const WordsOfBlock& block, std::string_view codes) {
    const Program& program = block.analysis.program();
    const Slice items = block.section.items;
    if (items.count == 0) return false;
    const Offset begin = block.block.span.end;
    const Offset end = std::min(program.span_of(items.first + items.count - 1).end,
                                lines_on(program.text, begin, most_later_lines));
    for (ItemId item = item_at(program, items, begin); item < items.first + items.count; ++item) {
        if (program.span_of(item).begin >= end) break;
        const auto* later = std::get_if<Block>(&program.items[item]);
        if (later != nullptr &&
            std::ranges::any_of(program.effects_in(later->effects), [](const Effect& effect) {
                return std::holds_alternative<Call>(effect.what);
            }))
            return true;
    }
    bool found = false;
    for_each_line_with(letters_of(codes), program.text, {begin, std::max(begin, end)},
                       [&](Span /*line*/) { found = true; });
    return found;
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
