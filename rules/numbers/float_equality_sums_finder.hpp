//! Sums whose steps may have decimals: ten steps of 0.1 are not 1.
#pragma once

#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <vector>

namespace maclint::rules {

/// Assignments in loops that add a step of unknown exactness, one for each variable.
using Sums = std::vector<const dataflow::Store*>;
[[nodiscard]] Sums find_sums(const ProgramAnalysis& analysis);

/// The sum that the expression reads, when it is a variable and nothing else; else nullptr.
[[nodiscard]] const dataflow::Store* sum_in(const ProgramAnalysis& analysis, const Sums& sums,
                                            ExpressionId expression);

} // namespace maclint::rules
