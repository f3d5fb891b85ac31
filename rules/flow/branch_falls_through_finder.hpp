//! Tables of jumps, of which one branch goes on into the next.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

#include <vector>

namespace maclint::rules {

/// The one branch of a table that does not leave.
struct FallingBranch {
    EffectId jump; ///< of the table, to the branch
    Span label;    ///< where the branch begins
    Span next;     ///< where the one begins into which it goes on
    Span leaves;   ///< how another branch of the table leaves
};

/// For each table the only branch that runs into the next one's label, where at least two of its others
/// leave by a jump to one and the same block, or end the program. A table is three tests or more in a row,
/// each whether one and the same variable is a number, that jump forwards to labels of their own. Of two
/// tests in a row the first branch, where it reads like the second but for numbers, stores something, and
/// only the second leaves.
[[nodiscard]] std::vector<FallingBranch> find_falling_branches(const ProgramAnalysis& analysis);

} // namespace maclint::rules
