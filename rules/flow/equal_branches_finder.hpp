//! Decisions both outcomes of which do the same.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

#include <vector>

namespace maclint::rules {

/// A condition that decides nothing.
struct EqualBranches {
    EffectId effect; ///< Guarded, or the RegionMark of a choice
    ExpressionId condition;
    /// What both sides do, the side first for which the condition is true; no bytes where both go on at
    /// once, as where a jump leads to the block behind it.
    Span if_true, if_false;
};

/// Of two branches that hold the same blocks, and after which the program goes on in one place or ends, in
/// the order of the text. No branch is compared that decides in turn, or into which a jump leads.
[[nodiscard]] std::vector<EqualBranches> find_equal_branches(const ProgramAnalysis& analysis);

} // namespace maclint::rules
