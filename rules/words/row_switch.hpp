//! The switches that rows name: what is known of them at a block, and in words.
#pragma once

#include "analyzer/machine/switched.hpp"
#include "analyzer/queries/words/block_words.hpp"
#include "rules/words/word_row.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace maclint {

/// What is known of the switch that the row names; nothing where that is not as the row wants it.
[[nodiscard]] std::optional<machine::Switched> switched_as(const queries::WordsOfBlock& block,
                                                           const WordRow& row);
/// The switch that must be off, or the first of several.
[[nodiscard]] std::string_view first_switch_off(const WordRow& row);
/// Where a code has no place: "while the C axis is off", "in FINISHED".
[[nodiscard]] std::string place_without(const WordRow& row);
/// "While the C axis is on: " of a row that holds only then.
[[nodiscard]] std::string switch_condition_of(const WordRow& row);

} // namespace maclint
