//! Loops whose counter is as a loop has left it: one before, or they themselves.
#pragma once

#include "analyzer/dataflow/loops.hpp"
#include "analyzer/queries/loops/loop_counter.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>
#include <vector>

namespace maclint::rules {

/// A variable that a condition asks for, and the loop that has counted it.
struct Left {
    Variable variable;
    const dataflow::Loop* loop;
};

/// What the condition at `condition` asks for and a loop before it has counted, where nothing between them
/// sets it; nothing where there is no such variable.
[[nodiscard]] std::optional<Left> left_by_a_loop(const ProgramAnalysis& analysis, Span condition);

/// A loop whose condition is as false when it is come to again as it was when the loop ended.
struct RunOnce {
    const dataflow::Loop* loop;
    const dataflow::Loop* around; ///< comes to it again
    queries::Counter counter;
};

/// In the order of the loops. Only where the counter alone ends the loop, by the condition before its first
/// block, and where nothing outside of it may change the counter or its bound.
[[nodiscard]] std::vector<RunOnce> find_loops_run_once(const ProgramAnalysis& analysis);

} // namespace maclint::rules
