//! Differences that a tolerance has shifted before their amount is taken.
#pragma once

#include "analyzer/program/ids.hpp"
#include "analyzer/source/span.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <vector>

namespace maclint::rules {

struct ShiftedDifference {
    EffectId effect;   ///< of the comparison
    ExpressionId side; ///< of it: the amount, or a variable that holds it
    Span difference;
    Span tolerance;
    bool is_stored; ///< the difference stands in another block
};

/// Sides of comparisons that are `ABS[a-b-t]`, `ABS[a-b+t]` or `ABS[a-[b+t]]`, in the block itself or by way
/// of a variable. A tolerance is a number so small that nobody means a place by it, a variable that holds
/// one, or one that a remark of the program calls so.
[[nodiscard]] std::vector<ShiftedDifference> find_shifted_differences(const ProgramAnalysis& analysis);

} // namespace maclint::rules
