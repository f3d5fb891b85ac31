//! Loops that count in steps which collect rounding errors.
#pragma once

#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/loops/loop_counter.hpp"
#include "analyzer/source/exemption.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <unordered_set>
#include <vector>

namespace maclint::queries {

/// By which an inexact counter may end a loop.
namespace exemptions {
inline constexpr Exemption tolerance_in_the_bound;
inline constexpr Exemption counter_held_at_a_limit;
} // namespace exemptions

/// A loop whose end depends on a sum of inexact steps.
struct InexactCounter {
    const dataflow::Store* step;
    CounterTest decisive;                           ///< the first of its tests that an error can turn
    std::vector<const dataflow::Comparison*> tests; ///< at least one

    /// The loop goes on until the counter is exactly its bound.
    [[nodiscard]] bool must_meet() const { return decisive.stays == Operation::not_equal; }
};

/// Each step once. Not: counters that are clamped to their bound, and bounds that lie between two steps.
[[nodiscard]] std::vector<InexactCounter> find_inexact_counters(const ProgramAnalysis& analysis);

/// The tests of all of them.
[[nodiscard]] std::unordered_set<const dataflow::Comparison*>
tests_of(const std::vector<InexactCounter>& counters);

} // namespace maclint::queries
