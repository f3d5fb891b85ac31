//! Findings of faults in the pairing of loops, choices and units.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"
#include "rules/rule.hpp"

namespace maclint {

/// Reports the fault under the message of its kind: "never-closed", "never-opened", "nested" or "crossed".
void report_nesting_fault(const ProgramAnalysis& analysis, const flow::RegionFault& fault,
                          Reporter& reporter);

} // namespace maclint
