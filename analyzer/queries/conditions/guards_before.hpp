//! Guards in a row, the later of which asks what an earlier one has decided.
#pragma once

#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/condition.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>
#include <vector>

namespace maclint::queries {

/// An earlier guard that is false whenever the program comes to a later one.
struct GuardBefore {
    EffectId effect;
    ExpressionId condition;
    bool same;  ///< both ask the very same
    bool makes; ///< what the later one always is, whatever number its variable holds
};

/// The guard in front of an IF that decides it by itself. Between the two stand only blocks that guard or
/// that store in other variables than the conditions read; nobody jumps in between.
[[nodiscard]] std::optional<GuardBefore> guard_that_decides(const ProgramAnalysis& analysis,
                                                            const dataflow::Condition& condition);

/// Whether the earlier comparison with a number turned out the same on every path from it to the condition,
/// and what it says of the value makes a comparison of the condition what it always is. Looks at no more than
/// `nodes_left` nodes, and takes those off.
[[nodiscard]] bool decides(const ProgramAnalysis& analysis, const dataflow::Comparison& earlier,
                           const dataflow::Condition& condition, std::size_t& nodes_left);

/// Arguments that the program uses as the call gives them, and that none of its conditions asks for; in the
/// order of their numbers.
[[nodiscard]] std::vector<Variable> untested_arguments(const ProgramAnalysis& analysis);

} // namespace maclint::queries
