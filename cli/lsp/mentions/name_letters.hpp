//! Of which bytes names are made.
#pragma once

#include "analyzer/dialect/characters.hpp"

namespace maclint::cli::lsp {

[[nodiscard]] constexpr bool is_letter_of_name(char c) { return is_letter(c) || c == '_' || c == '$'; }
[[nodiscard]] constexpr bool is_of_name(char c) { return is_letter_of_name(c) || is_digit(c); }

} // namespace maclint::cli::lsp
