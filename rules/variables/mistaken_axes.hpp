//! Messages about variables of another axis, offset or counter (MAC215).
#pragma once

#include "analyzer/workspace/program_analysis.hpp"
#include "rules/reporter.hpp"

namespace maclint::rules {

/// Tells of statements that go on from the variable of a sibling, and of places kept for one axis that move
/// another.
void report_mistaken_axes(const ProgramAnalysis& analysis, Reporter& reporter);

} // namespace maclint::rules
