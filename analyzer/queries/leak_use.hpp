//! What becomes of a modal state that a called program leaves behind.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

#include <optional>

namespace maclint::queries {

/// Whether somebody works under the state that a program leaves in a modal group when it returns.
struct LeakUse {
    /// Some caller moves before it sets the group again, or not all callers are known.
    bool matters;
    const ProgramAnalysis* program; ///< whose block it is; nullptr when no block is known
    Span block;                     ///< the first block found that moves so
};

/// Follows the callers of a program from their calls on. A feed or speed matters to moves that have one, any
/// other group to every move. Without known callers everything matters.
[[nodiscard]] LeakUse leak_use_of(const ProgramAnalysis& callee, GroupId group);

} // namespace maclint::queries
