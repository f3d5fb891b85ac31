//! What MAC555 says of rapid moves at a depth.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"
#include "rules/reporter.hpp"

namespace maclint::rules {

void report_rapid_moves(const ProgramAnalysis& analysis, Reporter& reporter);

} // namespace maclint::rules
