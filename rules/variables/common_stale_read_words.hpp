//! What MAC216 says.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"
#include "rules/reporter.hpp"

namespace maclint::rules {

void report_limits(const ProgramAnalysis& analysis, Reporter& reporter);
void report_cases(const ProgramAnalysis& analysis, Reporter& reporter);
void report_ways(const ProgramAnalysis& analysis, Reporter& reporter);

} // namespace maclint::rules
