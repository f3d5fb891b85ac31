//! Findings of modal groups that a program leaves other than it found them.
#pragma once

#include "analyzer/queries/modal_leaks.hpp"
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

/// Reports the leak where it was set, with the path there and the path to the exit.
void report_leak(const ProgramAnalysis& analysis, Reporter& reporter, const queries::ModalLeak& leak,
                 std::string_view message_id, std::vector<std::string> arguments);
/// The same with the message "every-path" or "some-paths".
void report_leak(const ProgramAnalysis& analysis, Reporter& reporter, const queries::ModalLeak& leak,
                 std::vector<std::string> arguments);

} // namespace maclint::rules
