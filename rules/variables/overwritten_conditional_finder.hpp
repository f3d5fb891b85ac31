//! Special cases that the condition of a later case takes in.
#pragma once

#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <vector>

namespace maclint::rules {

/// An assignment under a condition, and the next one of the same variable, whose own condition is always true
/// where the first has been.
struct CoveredCase {
    const dataflow::Store* store;
    ExpressionId condition;
    const dataflow::Store* replaced_by;
    ExpressionId later_condition;
};

/// In the order of facts. Nothing but assignments and tests stands between the two, and nothing that reads
/// the variable. Whether the second is always made is asked of the search for paths; where that gives up the
/// case is left out.
[[nodiscard]] std::vector<CoveredCase> find_covered_cases(const ProgramAnalysis& analysis);

} // namespace maclint::rules
