//! Comparisons of numbers that rounding has touched.
#pragma once

#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/queries/inexact_sums.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>

namespace maclint::queries {

/// What makes a side of a comparison inexact.
struct InexactSide {
    ExpressionId side;
    dataflow::OriginId rounding; ///< where it was rounded; 0: summed up by `sum`
    const dataflow::Store* sum;  ///< nullptr when it was rounded
};

/// The first side that was rounded, else the first that is one of the sums; nothing when neither is.
[[nodiscard]] std::optional<InexactSide> inexact_side(const ProgramAnalysis& analysis, const Sums& sums,
                                                      const dataflow::Comparison& comparison);

/// Whether EQ and NE tell the truth of the two sides although one is rounded: both are one value, a product
/// or quotient is compared with 0, a number with itself made whole, or a variable with what is copied into
/// it.
[[nodiscard]] bool is_decided_exactly(const ProgramAnalysis& analysis,
                                      const dataflow::Comparison& comparison);

} // namespace maclint::queries
