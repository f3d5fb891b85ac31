//! Zeros in front of a number make no other word of it.
#include "cli/config/shop_words.hpp"

#include "analyzer/dialect/characters.hpp"
#include "cli/text/letters.hpp"

#include <algorithm>
#include <cstddef>

namespace maclint::cli {
namespace {

constexpr std::size_t longest_word = 100; ///< bytes

} // namespace

std::optional<std::string> one_spelling(std::string_view word) {
    if (word.empty() || word.size() > longest_word) return std::nullopt;
    if (std::ranges::any_of(word, [](char c) { return static_cast<unsigned char>(c) <= ' '; }))
        return std::nullopt;
    std::string text = in_upper_case(word);
    const auto number = static_cast<std::size_t>(std::ranges::find_if(text, is_digit) - text.begin());
    std::size_t zeros = number;
    while (zeros + 1 < text.size() && text[zeros] == '0' && is_digit(text[zeros + 1])) ++zeros;
    text.erase(number, zeros - number);
    return text;
}

const std::string* meaning_in(const ShopWords& words, std::string_view word) {
    if (words.empty()) return nullptr;
    const auto spelling = one_spelling(word);
    const auto found = spelling ? words.find(*spelling) : words.end();
    return found == words.end() ? nullptr : &found->second;
}

} // namespace maclint::cli
