//! Modes of a lathe that have no custom, left changed by a called program.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"
#include "rules/reporter.hpp"

namespace maclint::rules {

/// Reports calls of the program that leave it the other feed or speed mode than it had, where it cuts in that
/// mode before it writes its own again. The message is "by-call".
void report_modes_left_by_calls(const ProgramAnalysis& analysis, Reporter& reporter);

} // namespace maclint::rules
