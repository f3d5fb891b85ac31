//! The block that comes after one, where the control surely goes there.
#pragma once

#include "analyzer/queries/block_words.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace maclint::queries {

/// The words of the next block that holds one with this letter: at most eight blocks on, in the same section,
/// with none between that does more than set modal codes. Nothing: there is none, or nobody knows.
[[nodiscard]] std::optional<std::vector<Word>> next_block_with(const WordsOfBlock& block, char letter);

/// Whether one of the words is one of the codes, which blanks separate: "G0 G1".
[[nodiscard]] bool holds_code(const std::vector<Word>& words, std::string_view codes);

} // namespace maclint::queries
