//! What becomes of a modal state that a called program leaves behind.
#pragma once

#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/source/exemption.hpp"
#include "analyzer/workspace/program_analysis.hpp"

namespace maclint::queries {

namespace exemptions {
inline constexpr Exemption speed_given_again; ///< who starts a spindle that stands gives its speed
} // namespace exemptions

/// Whether somebody works under the state that a program leaves in a modal group when it returns.
struct LeakUse {
    /// Some caller moves before it sets the group again, or not all callers are known.
    bool matters = false;
    const ProgramAnalysis* program = nullptr; ///< whose block it is; nullptr when no block is known
    Span block = {};                          ///< the first block found that moves so
    /// The caller set the group itself before the call: that is what it loses. Of the motion mode and of
    /// offsets, only where each of its codes is another than what is left.
    bool own_is_lost = false;
    bool gives_feed = false; ///< of the motion mode: the block states a feed
};

/// Follows the callers of a program from their calls on, after it was left there with what node `set` set. A
/// feed or speed matters to moves that have one, the motion mode to blocks that state none, any other group
/// to every move. Without known callers everything matters, but the speed of a spindle that stands: who
/// starts it states its speed. Of callers that rely on it, one that itself loses a value of its own is found
/// before others.
[[nodiscard]] LeakUse leak_use_of(const ProgramAnalysis& callee, GroupId group,
                                  const dataflow::ExitState& exit, flow::NodeId set);

} // namespace maclint::queries
