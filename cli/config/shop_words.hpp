//! What a shop calls codes and variables: the key "words" of a configuration.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace maclint::cli {

/// One spelling for all ways in which programs write a word: "M8" for "m08", "#550" for "#0550", "DIAMON" for
/// "Diamon". Nothing where blanks stand in it, or it is longer than any word of a program.
[[nodiscard]] std::optional<std::string> one_spelling(std::string_view word);

/// Meanings by such spellings.
using ShopWords = std::map<std::string, std::string, std::less<>>;

/// What the shop says of a word as a program writes it, or nullptr.
[[nodiscard]] const std::string* meaning_in(const ShopWords& words, std::string_view word);

} // namespace maclint::cli
