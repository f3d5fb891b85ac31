//! Rows in words, for messages and pages.
#pragma once

#include "rules/words/rule_row.hpp"

#include <string>

namespace maclint {

/// The row's words and what they are: "Q (depth of a peck)", "X or Z (end point)".
[[nodiscard]] std::string words_with_meaning(const WordRow& row);

/// The values that the row allows: "0, 1 or 2", "at least 1", "more than 0 and at most 999".
[[nodiscard]] std::string values_allowed_by(const WordRow& row);

/// Whether the row takes the value; one that says nothing of values takes any.
[[nodiscard]] bool takes(const WordRow& row, double value);

/// The words beside which those of the row count: "ID", "Q of 1, 2 or 3 or A".
[[nodiscard]] std::string partners_of(const WordRow& row);

/// "BLANK, FINISHED and FACE C".
[[nodiscard]] std::string sections_in_words(std::string_view sections);

/// "G83", as the row names it.
[[nodiscard]] std::string code_of(const RowForCode& row);

} // namespace maclint
