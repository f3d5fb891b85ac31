//! Questions about what happens on every way to a place.
#pragma once

#include "analyzer/dataflow/analysis.hpp"

namespace maclint::dataflow {

/// Whether every way from the program's start to the node passes an assignment to the variable.
[[nodiscard]] bool assigned_on_every_way(const flow::Graph& graph, const Analysis& analysis, Place place,
                                         flow::NodeId node);

} // namespace maclint::dataflow
