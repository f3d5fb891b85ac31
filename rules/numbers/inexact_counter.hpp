//! Loops that count in steps which collect rounding errors.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

#include <vector>

namespace maclint::rules {

/// A loop whose end depends on a sum of inexact steps.
struct InexactCounter {
    const dataflow::Store* step;
    std::vector<const dataflow::Comparison*> tests; ///< at least one
};

/// Each step once. Not: counters that are clamped to their bound, and bounds that lie between two steps.
[[nodiscard]] std::vector<InexactCounter> find_inexact_counters(const ProgramAnalysis& analysis);

/// Whether the comparison is a test of one of the counters.
[[nodiscard]] bool decides(const std::vector<InexactCounter>& counters,
                           const dataflow::Comparison& comparison);

} // namespace maclint::rules
