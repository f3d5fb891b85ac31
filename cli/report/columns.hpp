//! Columns of a terminal: how many a text takes, and text wrapped to them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::cli {

/// Columns that a character takes: 0 when it sits on the one before, 2 when it is wide, else 1.
[[nodiscard]] std::size_t columns_of(char32_t character);
/// Columns of printable UTF-8 without tabs.
[[nodiscard]] std::size_t columns_of(std::string_view utf8);

/// The words of printable UTF-8 in lines of at most `width` columns, the first of at most `first`. A word
/// that is longer has a line for itself.
[[nodiscard]] std::vector<std::string> wrapped(std::string_view text, std::size_t first, std::size_t width);

} // namespace maclint::cli
