//! The rows that the chapters of codes amount to.
#pragma once

#include "rules/words/word_row.hpp"

#include <vector>

namespace maclint {

/// A table for each chapter, and one for each language: where its codes have no place. Made once.
[[nodiscard]] const std::vector<const WordTable*>& tables_of_books();

} // namespace maclint
