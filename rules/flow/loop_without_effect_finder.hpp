//! Loops that only count, and whose counts nobody reads.
#pragma once

#include "analyzer/dataflow/loops.hpp"
#include "analyzer/source/exemption.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>
#include <vector>

namespace maclint::rules {

/// By which a loop may only count.
namespace exemptions {
inline constexpr Exemption counts_to_a_number;
} // namespace exemptions

struct LoopWithoutEffect {
    const dataflow::Loop* loop;
    Variable counted;             ///< that it changes, and its condition asks for
    std::optional<EffectId> anew; ///< the store behind it that replaces the count
};

/// Loops that do nothing but store in variables, none of which may be read behind them. In text order.
[[nodiscard]] std::vector<LoopWithoutEffect> find_loops_without_effect(const ProgramAnalysis& analysis);

} // namespace maclint::rules
