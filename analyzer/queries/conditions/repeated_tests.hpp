//! Tests that ask again what the text has asked just before.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

#include <optional>
#include <vector>

namespace maclint::queries {

/// A test that stands twice.
struct RepeatedTest {
    EffectId effect;     ///< Guarded or RegionMark that asks again
    ExpressionId first;  ///< says the same as
    ExpressionId second; ///< this one, later in the text
    /// Where two IFs with the same condition set one variable, and nothing else happens between: what the
    /// first sets, which nobody reads.
    std::optional<EffectId> lost;
};

/// Parts of one condition, joined by the same word of logic, and conditions of IFs in a row. Of the latter
/// the first is named that the second repeats.
[[nodiscard]] std::vector<RepeatedTest> find_repeated_tests(const ProgramAnalysis& analysis);

} // namespace maclint::queries
