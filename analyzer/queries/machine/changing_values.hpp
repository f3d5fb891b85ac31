//! Values of the machine that may differ each time they are read.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

namespace maclint::queries {

/// Whether an input, a position, a timer or the like stands in the expression, or an index that may mean one.
[[nodiscard]] bool reads_what_changes(const ProgramAnalysis& analysis, ExpressionId expression);

} // namespace maclint::queries
