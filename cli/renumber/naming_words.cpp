//! Which codes take a contour is told by the rows of rules that look at it.
#include "cli/renumber/naming_words.hpp"

#include "analyzer/program/tables.hpp"
#include "analyzer/queries/words/enclosed_blocks.hpp"
#include "rules/words/row_place.hpp"
#include "rules/words/rule_row.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>

namespace maclint::cli {
namespace {

/// Words that name blocks beside any code, by language.
struct LanguageWords {
    std::string_view language, addresses;
};
constexpr std::array<LanguageWords, 1> language_words{
    {{"dinplus", "NS NE"}}}; // SEED-003:12483, DIN PLUS manual

std::string_view words_of_language(std::string_view language) {
    const auto* const row = std::ranges::find(language_words, language, &LanguageWords::language);
    return row == language_words.end() ? std::string_view() : row->addresses;
}

/// A code, and an address beside it that names a block.
using CodeWord = std::pair<std::pair<char, double>, std::string_view>;

/// Of all codes that enclose blocks on the control.
std::set<CodeWord> enclosing_words(const ControlModel& control) {
    std::set<CodeWord> found;
    for (const RuleRow& rule_row : all_rule_rows())
        for (const RowForCode& row : rule_row.rows)
            if (row.row->says == RowStatement::encloses && is_of(row, control))
                for (const std::string_view address : maclint::words_of(row.row->words))
                    found.insert({{row.letter, row.code}, address});
    return found;
}

const Word* word_with(std::span<const Word> words, std::string_view address) {
    const auto word = std::ranges::find(words, address, &Word::address);
    return word == words.end() ? nullptr : &*word;
}

bool is_code(const Word& word, char letter, double code) {
    const auto* literal = std::get_if<Literal>(&word.value);
    return literal != nullptr && word.address.size() == 1 && word.address.front() == letter &&
           literal->value == code;
}

/// `M98 P9100 Q20`; without P the block is one of the calling program.
void visit_call(std::span<const Word> words, const std::function<void(const Word&, const NamedIn&)>& visit) {
    constexpr double call = 98;
    const bool calls = std::ranges::any_of(words, [](const Word& word) { return is_code(word, 'M', call); });
    const Word *program = word_with(words, "P"), *block = word_with(words, "Q");
    if (!calls || program == nullptr || block == nullptr) return;
    if (const auto number = queries::block_number(*program)) visit(*block, {number});
}

} // namespace

void for_each_naming_word(const Program& program,
                          const std::function<void(const Word&, const NamedIn&)>& visit) {
    const std::string_view always = words_of_language(program.control->language);
    const std::set<CodeWord> enclosing = enclosing_words(*program.control);
    queries::for_each_block_in(program, program.span, [&](const BlockView&, std::span<const Word> words) {
        for (const Word& word : words)
            if (has_word(always, word.address)) visit(word, {});
        for (const auto& [code, address] : enclosing) {
            const auto has_code = [&, letter = code.first, number = code.second](const Word& word) {
                return is_code(word, letter, number);
            };
            const Word* word = word_with(words, address);
            if (word != nullptr && std::ranges::any_of(words, has_code)) visit(*word, {});
        }
        if (always.empty()) visit_call(words, visit);
    });
}

} // namespace maclint::cli
