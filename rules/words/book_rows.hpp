//! The rows that the chapters of codes amount to.
#pragma once

#include "rules/words/word_row.hpp"

#include <string_view>
#include <vector>

namespace maclint {

/// What comes of a value that a list of the manual does not hold.
inline constexpr std::string_view no_other_value = "the manual knows no other";

/// A table for each chapter, and one for each language: where its codes have no place. Made once.
[[nodiscard]] const std::vector<const WordTable*>& tables_of_books();

} // namespace maclint
