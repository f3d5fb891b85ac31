//! Positions that are compared with where a move was to end, some with a tolerance and some without.
#pragma once

#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <vector>

namespace maclint::rules {

/// A comparison without a tolerance, where another of the same program has one.
struct MissingTolerance {
    const dataflow::Comparison* exact;
    const dataflow::Comparison* tolerant; ///< the first in the text
    ExpressionId tolerance;               ///< the number that it adds or takes away
};

/// By LT, LE, GT or GE, right after a move, of positions of one kind.
[[nodiscard]] std::vector<MissingTolerance> find_missing_tolerances(const ProgramAnalysis& analysis);

} // namespace maclint::rules
