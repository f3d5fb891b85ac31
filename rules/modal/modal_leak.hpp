//! Modal groups that a program leaves other than it found them.
#pragma once

#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/workspace/leak_use.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/finding.hpp"
#include "rules/rule.hpp"

#include <functional>
#include <string>
#include <vector>

namespace maclint::rules {

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

/// One leak for each group of this concern. A group of which somebody else may have changed something
/// unknown is left out, so is what a called program left: that program is reported; and so is what every
/// known caller sets again before it moves.
[[nodiscard]] std::vector<ModalLeak> find_modal_leaks(const ProgramAnalysis& analysis,
                                                      RestorePolicy restore_policy, const IsFault& is_fault);

/// The code of the part, when a literal word of this program set it: `G91`, not `G#3`.
[[nodiscard]] std::optional<double> own_code(const ProgramAnalysis& analysis,
                                             const dataflow::ModalPart& part);

/// Whether the part is a code of this program's own that is no customary one of its group.
[[nodiscard]] bool is_switched_on(const ProgramAnalysis& analysis, const ModalGroup& group,
                                  const dataflow::ModalPart& part);

/// The word that set the part, for a message: as it is written, or in a plain block, whose words are not
/// kept, as its group spells it.
[[nodiscard]] std::string word_of(const ProgramAnalysis& analysis, GroupId group,
                                  const dataflow::ModalPart& part);

/// The bytes that set the part.
[[nodiscard]] Span variable_of(const ProgramAnalysis& analysis, const ModalLeak& leak);

/// Reports the leak where it was set, with the path there and the path to the exit.
void report_leak(const ProgramAnalysis& analysis, Reporter& reporter, const ModalLeak& leak,
                 std::string_view message_id, std::vector<std::string> arguments);
/// The same with the message "every-path" or "some-paths".
void report_leak(const ProgramAnalysis& analysis, Reporter& reporter, const ModalLeak& leak,
                 std::vector<std::string> arguments);

} // namespace maclint::rules
