//! Reads conditions and holds them against a block.
#include "rules/words/row_condition.hpp"

#include "rules/path.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>
#include <variant>

namespace maclint {
namespace {

std::string listed(std::string_view values) {
    std::string list(values);
    std::ranges::replace(list, '|', ' ');
    return list;
}

bool holds(const queries::WordsOfBlock& block, const Word& code, const RowCondition& condition) {
    const auto word = std::ranges::find_if(
        block.words, [&](const Word& one) { return &one != &code && one.address == condition.address; });
    if (word == block.words.end()) return !condition.there || condition.or_missing;
    const Fits wanted = condition.others ? Fits::no : Fits::yes;
    return condition.there && (condition.values.empty() || fits(*word, condition.values) == wanted);
}

} // namespace

RowCondition condition_of(std::string_view text) {
    RowCondition condition;
    condition.there = !text.starts_with('-');
    if (!condition.there) text.remove_prefix(1);
    const std::size_t sign = text.find_first_of("=?!");
    condition.address = text.substr(0, sign);
    if (sign == std::string_view::npos) return condition;
    condition.or_missing = text[sign] == '?';
    condition.others = text[sign] == '!';
    condition.values = text.substr(sign + 1);
    return condition;
}

Fits fits(const Word& word, std::string_view values) {
    const auto* value = std::get_if<Literal>(&word.value);
    if (value == nullptr) return Fits::unknown;
    return has_word(listed(values), number_word(value->value)) ? Fits::yes : Fits::no;
}

bool holds_beside(const queries::WordsOfBlock& block, const Word& code, std::string_view conditions) {
    return std::ranges::all_of(words_of(conditions), [&](std::string_view condition) {
        return holds(block, code, condition_of(condition));
    });
}

std::string in_words(const RowCondition& condition) {
    std::string address(condition.address);
    if (!condition.there) return "no " + address;
    if (condition.values.empty()) return address;
    return (condition.or_missing ? "no " + address + " or " : "") + address +
           (condition.others ? " other than " : " of ") + either_of(listed(condition.values));
}

std::string conditions_in_words(std::string_view conditions) {
    std::string text;
    for (const std::string_view condition : words_of(conditions))
        text += (text.empty() ? "With " : " and ") + in_words(condition_of(condition));
    return text;
}

} // namespace maclint
