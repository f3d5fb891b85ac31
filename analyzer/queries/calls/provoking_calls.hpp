//! Where known calls lead in the program that they call.
#pragma once

#include "analyzer/flow/graph.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <span>
#include <vector>

namespace maclint::queries {

/// The first known call that leaves the argument out and that nothing it passes or leaves out keeps from the
/// path, which begins at the program's start; nullptr when there is none. Asked are the conditions on the
/// path that compare an argument, as the call gives it, with a number or with vacant.
[[nodiscard]] const Caller* call_that_leaves_out(const ProgramAnalysis& analysis, Variable argument,
                                                 std::span<const flow::EdgeId> path);

/// The nodes of the program that the call can come to as far as such conditions tell, by paths that do not go
/// on from the nodes `ends` (sorted). The call gives the program local variables of its own.
[[nodiscard]] std::vector<bool> nodes_reached_by(const ProgramAnalysis& analysis, const Caller& call,
                                                 std::span<const flow::NodeId> ends);

} // namespace maclint::queries
