//! The blocks around one: what comes next, where the control surely goes there, and what stands before and
//! after.
#pragma once

#include "analyzer/queries/words/block_words.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace maclint::queries {

/// The words of the next block that holds one with this letter: at most eight blocks on, in the same section,
/// with none between that does more than set modal codes. Nothing: there is none, or nobody knows.
[[nodiscard]] std::optional<std::vector<Word>> next_block_with(const WordsOfBlock& block, char letter);

/// The words of the last block before this one in the text that holds a word with this letter, in the same
/// section; a word without a value where a call may have run others. Nothing:
/// there is none.
[[nodiscard]] std::optional<std::vector<Word>> last_block_with(const WordsOfBlock& block, char letter);

/// Whether one of the next two hundred lines of the section holds one of the codes, in a comment or not,
/// or calls a program that may.
[[nodiscard]] bool comes_later(const WordsOfBlock& block, std::string_view codes);

/// Whether one of the words is one of the codes, which blanks separate: "G0 G1".
[[nodiscard]] bool holds_code(const std::vector<Word>& words, std::string_view codes);

} // namespace maclint::queries
