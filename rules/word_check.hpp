//! Rules on words: what such a rule looks at, and the one pass over a program's words that they all share.
#pragma once

#include "analyzer/program/block_view.hpp"
#include "rules/rule.hpp"

#include <span>
#include <vector>

namespace maclint {

/// A block and its words; good as long as the check runs.
struct WordsOfBlock {
    const ProgramAnalysis& analysis;
    const BlockView& block;
    std::span<const Word> words;
    bool modal_calls; ///< calls of the program act on blocks after them
};

/// Whether words of the block may be skipped or stand under a condition: then two that exclude each other may
/// be alternatives.
[[nodiscard]] bool has_alternatives(const WordsOfBlock& block);

/// Whether the block calls a program, or may: by a code that no table knows, or after its move.
[[nodiscard]] bool may_call(const WordsOfBlock& block);

/// Runs the word checks among the rules over a program: the findings of each, in the order of `rules`.
/// Blocks that none of them can want are not read.
[[nodiscard]] std::vector<Finding> check_words(const ProgramAnalysis& analysis,
                                               std::span<const Rule* const> rules);

} // namespace maclint
