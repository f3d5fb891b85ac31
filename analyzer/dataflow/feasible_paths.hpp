//! Paths through a program around every assignment to a variable.
#pragma once

#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/dataflow/loops.hpp"

#include <optional>
#include <span>
#include <vector>

namespace maclint::dataflow {

/// Whether every path from the program's start to the node passes an assignment to the variable.
[[nodiscard]] bool assigned_on_every_path(const flow::Graph& graph, const Analysis& analysis,
                                          Variable variable, flow::NodeId node);

/// The assignments to the variable that can be the last one before the loop begins.
[[nodiscard]] std::vector<const Store*> last_stores_before(const flow::Graph& graph, const Analysis& analysis,
                                                           Variable variable, const Loop& loop);

/// A path from the program's start to the node on which nothing can have changed the variable, and whose
/// conditions do not contradict each other. Nothing when none is found in a few attempts.
[[nodiscard]] std::optional<std::vector<flow::EdgeId>>
path_without_assignment(const Program& program, const flow::Graph& graph, const Analysis& analysis,
                        Variable variable, flow::NodeId node);

/// Whether the program can come over `first` to `then`: by a path whose conditions do not contradict each
/// other, and that meets none of the nodes `barred` (sorted) between the two. Looked for in a few attempts.
[[nodiscard]] bool can_follow(const Program& program, const flow::Graph& graph, const Analysis& analysis,
                              flow::NodeId first, flow::NodeId then,
                              std::span<const flow::NodeId> barred = {});

} // namespace maclint::dataflow
