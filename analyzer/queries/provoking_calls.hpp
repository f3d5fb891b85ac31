//! Which known call makes a program go a path.
#pragma once

#include "analyzer/flow/graph.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <span>

namespace maclint::queries {

/// The first known call that leaves the argument out and that nothing it passes or leaves out keeps from the
/// path, which begins at the program's start; nullptr when there is none. Asked are the conditions on the
/// path that compare an argument, as the call gives it, with a number or with vacant.
[[nodiscard]] const Caller* call_that_leaves_out(const ProgramAnalysis& analysis, Variable argument,
                                                 std::span<const flow::EdgeId> path);

} // namespace maclint::queries
