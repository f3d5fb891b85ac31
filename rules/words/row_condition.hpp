//! Puts the conditions of rows into words.
#pragma once

#include "analyzer/program/word_condition.hpp"

#include <string>
#include <string_view>

namespace maclint {

/// "Q of 1 or 2", "no A".
[[nodiscard]] std::string in_words(const WordCondition& condition);
/// A value that an example of the condition has; empty: any but those that it excludes.
[[nodiscard]] std::string_view fitting_value(const WordCondition& condition);
/// "With Q of 1 or 2 and no A".
[[nodiscard]] std::string conditions_in_words(std::string_view conditions);

} // namespace maclint
