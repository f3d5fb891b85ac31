//! Modal groups that a program leaves other than it found them.
#pragma once

#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/queries/leak_use.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <functional>
#include <vector>

namespace maclint::queries {

/// A word of the program whose effect on a modal group is still in force when the program is left.
struct ModalLeak {
    GroupId group;
    dataflow::ModalPart part;        ///< the last in the text that sets the group so
    const dataflow::ExitState* exit; ///< where it is still in force
    bool on_every_path;              ///< false: on other paths the program puts the group right
    LeakUse leak_use;                ///< what callers do with it
};

/// Whether what a group can be at an exit is something that the rule reports.
using IsFault =
    std::function<bool(const ModalGroup&, GroupId, const dataflow::ExitState&, const dataflow::ModalPart&)>;

/// One leak for each group with this policy. A group of which somebody else may have changed something
/// unknown is left out, so is what a called program left: that program is reported; and so is what every
/// known caller sets again before it moves. None of a program that may run blocks of its own as a subprogram.
[[nodiscard]] std::vector<ModalLeak> find_modal_leaks(const ProgramAnalysis& analysis,
                                                      RestorePolicy restore_policy, const IsFault& is_fault);

} // namespace maclint::queries
