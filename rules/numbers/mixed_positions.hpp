//! What MAC230 says of positions that count from two zeros.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"
#include "rules/reporter.hpp"

namespace maclint::rules {

void report_mixed_positions(const ProgramAnalysis& analysis, Reporter& reporter);

} // namespace maclint::rules
