//! Words of a block by their addresses.
#pragma once

#include "analyzer/program/model.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>
#include <variant>

namespace maclint {

/// The first word with the address; nullptr: there is none.
[[nodiscard]] inline const Word* find_word(std::span<const Word> words, std::string_view address) {
    const auto word = std::ranges::find(words, address, &Word::address);
    return word == words.end() ? nullptr : &*word;
}

/// The number of a word that is there and written as one; nothing of one that is calculated.
[[nodiscard]] inline std::optional<double> number_of(const Word* word) {
    const auto* literal = word == nullptr ? nullptr : std::get_if<Literal>(&word->value);
    return literal == nullptr ? std::nullopt : std::optional(literal->value);
}
[[nodiscard]] inline std::optional<double> number_of(std::span<const Word> words, std::string_view address) {
    return number_of(find_word(words, address));
}

} // namespace maclint
