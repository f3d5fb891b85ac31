//! Tests for vacancy that never find it, and what they were for.
#pragma once

#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>

namespace maclint::queries {

/// Whether the test makes no difference: what it guards only sets the tested variable, or the value is a copy
/// of one that was tested before.
[[nodiscard]] bool is_harmless_guard(const ProgramAnalysis& analysis, const dataflow::Comparison& test,
                                     Variable variable);

/// The last assignment to the variable before the node, in the order of the text; nullptr when there is none.
[[nodiscard]] const dataflow::Store* last_store_before(const ProgramAnalysis& analysis, Variable variable,
                                                       flow::NodeId node);

/// Another variable to which the value from the call was copied before it was overwritten.
[[nodiscard]] std::optional<Variable> keeper_of_argument(const ProgramAnalysis& analysis, Variable variable,
                                                         flow::NodeId before);

} // namespace maclint::queries
