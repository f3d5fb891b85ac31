//! Whether a call ends a loop around it by an alarm.
#pragma once

#include "analyzer/dataflow/facts/call_made.hpp"
#include "analyzer/dataflow/loops.hpp"
#include "analyzer/dataflow/solver/analysis.hpp"

namespace maclint::dataflow {

/// Whether the program that is called may stop in some round of the loop, though not in the first: what
/// decides that is read from the machine, unknown, or changed by the loop or by what it calls.
[[nodiscard]] bool may_stop_later(const Program& program, const flow::Graph& graph, const Analysis& analysis,
                                  const CallMade& made, const Loop& loop);

} // namespace maclint::dataflow
