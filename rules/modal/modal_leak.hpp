//! Findings of modal groups that a program leaves other than it found them.
#pragma once

#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/modal/modal_leaks.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/finding.hpp"
#include "rules/rule.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace maclint::rules {

/// The word that set the part, for a message: as it is written, or in a plain block, whose words are not
/// kept, as its group spells it.
[[nodiscard]] std::string word_of(const ProgramAnalysis& analysis, GroupId group,
                                  const dataflow::ModalPart& part);

/// What ends what a group has in force: "G67", "G16 Q0".
[[nodiscard]] std::string words_to_cancel(const ControlModel& control, GroupId group);
/// The name of the group as the first word of a sentence.
[[nodiscard]] std::string capital_name(const ProgramAnalysis& analysis, GroupId group);

/// What is left, as the first words of a sentence: "Feed 'F100'", "Feed set by 'G65 P9390'".
[[nodiscard]] std::string subject_of(const ProgramAnalysis& analysis, const queries::ModalLeak& leak);

/// What to write so that the caller's state is put back, as a sentence without its full stop.
[[nodiscard]] std::string cure_by_saving(const ProgramAnalysis& analysis, const queries::ModalLeak& leak);

/// Where the program is left with it: "the M99 of line 52".
[[nodiscard]] std::string exit_text(const ProgramAnalysis& analysis, const queries::ModalLeak& leak);
/// The variables that the assignments save, as they are written, each once: "#4001".
[[nodiscard]] std::vector<std::string> variables_saved(const ProgramAnalysis& analysis,
                                                       const std::vector<const dataflow::Store*>& saves);

/// The block that sets the part: what rules speak of that say that nothing is put back.
[[nodiscard]] Cause block_cause(const ProgramAnalysis& analysis, const dataflow::ModalPart& part);

/// Reports the leak where it was set, with the path there and the path to the exit.
Finding& report_leak(const ProgramAnalysis& analysis, Reporter& reporter, const queries::ModalLeak& leak,
                     const Cause& cause, std::string_view message_id, std::vector<std::string> arguments);
/// The same with the effect as cause, and the message "every-path" or "some-paths".
Finding& report_leak(const ProgramAnalysis& analysis, Reporter& reporter, const queries::ModalLeak& leak,
                     std::vector<std::string> arguments);

} // namespace maclint::rules
