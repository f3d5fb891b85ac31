//! Of which bytes names are made.
#pragma once

namespace maclint::cli::lsp {

[[nodiscard]] constexpr bool is_letter_of_name(char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' || c == '$';
}
[[nodiscard]] constexpr bool is_of_name(char c) { return is_letter_of_name(c) || (c >= '0' && c <= '9'); }

} // namespace maclint::cli::lsp
