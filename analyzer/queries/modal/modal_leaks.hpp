//! Modal groups that a program leaves other than it found them.
#pragma once

#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/program/modal_groups.hpp"
#include "analyzer/queries/modal/kept_state.hpp"
#include "analyzer/queries/modal/leak_use.hpp"
#include "analyzer/source/exemption.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace maclint::queries {

namespace exemptions {
inline constexpr Exemption only_sets_modes;      ///< the program is there to set them for its callers
inline constexpr Exemption callers_cancel;       ///< every caller ends what the program has switched on
inline constexpr Exemption angle_of_the_spindle; ///< S beside M19 is where the spindle stops
inline constexpr Exemption returns_within;       ///< blocks of the program may run as its own subprogram
} // namespace exemptions

/// A word of the program whose effect on a modal group is still in force when the program is left.
struct ModalLeak {
    GroupId group;
    dataflow::ModalPart part;        ///< the last in the text that sets the group so; a call only where no
                                     ///< word does
    const dataflow::ExitState* exit; ///< where it is still in force
    bool on_every_path;              ///< false: on other paths the program puts the group right
    LeakUse leak_use;                ///< what callers do with it; nobody looks where the state is kept
    std::optional<KeptState> kept;   ///< the program keeps what its callers had, which is not put back there
};

/// Whether what a group can be at an exit is something that the rule reports.
using IsFault =
    std::function<bool(const ModalGroup&, GroupId, const dataflow::ExitState&, const dataflow::ModalPart&)>;

/// One leak for each group with this policy. Left out are states that something unknown may have changed on
/// every path to the exit; what a called program left, for which it answers itself, unless it is a feed or
/// speed and this program keeps its callers' state; and what every known caller sets again before it moves.
/// Of a group whose state the program keeps everything else that it leaves at a return is a fault, whatever
/// its callers do.
[[nodiscard]] std::vector<ModalLeak> find_modal_leaks(const ProgramAnalysis& analysis,
                                                      RestorePolicy restore_policy, const IsFault& is_fault);

} // namespace maclint::queries
