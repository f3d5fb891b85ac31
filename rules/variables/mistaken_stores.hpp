//! What MAC213 says of stores that go to another variable than was meant.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"
#include "rules/reporter.hpp"

namespace maclint::rules {

/// Of a variable that is set in vain beside one that is never set, and of offsets that are set twice.
void report_mistaken_stores(const ProgramAnalysis& analysis, Reporter& reporter);

} // namespace maclint::rules
