//! How a program ends in an alarm: because it is called for that, or because it should have returned.
#pragma once

#include "analyzer/dataflow/solver/summary.hpp"
#include "analyzer/flow/graph.hpp"

#include <vector>

namespace maclint::dataflow {

/// `reached` says of each node whether a path leads to it; `returns`, whether the program comes back.
[[nodiscard]] AlarmEnd find_alarm_end(const Program& program, const flow::Graph& graph,
                                      const Callees& callees, const std::vector<bool>& reached, bool returns);

/// Whether blocks that no jump leads to the alarm of the exit run into it, and a jump leads there as well:
/// the alarm is one for a test, and the way past it is missing.
[[nodiscard]] bool is_fallen_into(const flow::Graph& graph, const flow::Exit& alarm);

} // namespace maclint::dataflow
