//! Rules on words: what such a rule looks at, and the one pass over a program's words that they all share.
#pragma once

#include "analyzer/queries/words/block_words.hpp"
#include "rules/rule.hpp"

#include <span>
#include <vector>

namespace maclint {

/// Runs the word checks among the rules, and the rows, over a program: the findings of each rule, in the
/// order of `rules`. Blocks that none of them can want are not read.
[[nodiscard]] std::vector<Finding> check_words(const ProgramAnalysis& analysis,
                                               std::span<const Rule* const> rules, const RowIndexes& rows);

} // namespace maclint
