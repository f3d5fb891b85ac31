//! What decides whether a called program stops instead of returning.
#pragma once

#include "analyzer/dataflow/facts/fact_lists.hpp"
#include "analyzer/dataflow/solver/summary.hpp"
#include "analyzer/flow/graph.hpp"

#include <vector>

namespace maclint::dataflow {

/// Asked for a program that may stop. `reached` says of each node whether a path leads to it.
[[nodiscard]] StopReasons find_stop_reasons(const Program& program, const flow::Graph& graph,
                                            const FactLists& facts, const std::vector<bool>& reached);

} // namespace maclint::dataflow
