//! What rules find in one file, or in one program.
#pragma once

#include "rules/bounds_met.hpp"
#include "rules/rule.hpp"

#include <stop_token>
#include <vector>

namespace maclint {

/// Everything that the selected rules find there, with what exemptions hold back where that is wanted; in no
/// order. The selection names the rows that run. Adds to `met` as run_rules does.
[[nodiscard]] std::vector<Finding> findings_in(const Selection& selection, const ProgramFile& file,
                                               std::vector<BoundMet>& met, const std::stop_token& stop);
[[nodiscard]] std::vector<Finding> findings_in(const Selection& selection, const ProgramAnalysis& program,
                                               std::vector<BoundMet>& met, const std::stop_token& stop);

} // namespace maclint
