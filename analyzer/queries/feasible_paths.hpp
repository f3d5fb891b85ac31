//! Paths through a program that somebody can go: around every assignment to a variable, or from one node to
//! another.
#pragma once

#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/dataflow/loops.hpp"
#include "analyzer/execution/path_search.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>
#include <span>
#include <vector>

namespace maclint::queries {

/// Whether every path from the program's start to the node passes an assignment to the variable, or comes to
/// one of the nodes `unreachable`, which no path without an assignment leads to.
[[nodiscard]] bool assigned_on_every_path(const ProgramAnalysis& analysis, Variable variable,
                                          flow::NodeId node, std::span<const flow::NodeId> unreachable = {});

/// The assignments to the variable that can be the last one before the loop begins.
[[nodiscard]] std::vector<const dataflow::Store*>
last_stores_before(const ProgramAnalysis& analysis, Variable variable, const dataflow::Loop& loop);

/// A path from the program's start to the node that the control can take and on which nothing can have
/// changed the variable, and from there on to the node `then` when that is asked for. `search` is one of the
/// same program.
[[nodiscard]] execution::PathFound path_without_assignment(execution::PathSearch& search,
                                                           const ProgramAnalysis& analysis, Variable variable,
                                                           flow::NodeId node,
                                                           std::optional<flow::NodeId> then = std::nullopt);

/// Whether the control can come over `first` to `then` by a path that meets none of the nodes `barred`
/// (sorted) between the two. False, too, when the search gives up.
[[nodiscard]] bool can_follow(const ProgramAnalysis& analysis, flow::NodeId first, flow::NodeId then,
                              std::span<const flow::NodeId> barred = {});

/// A path from one node to the other that the control can take, when it has come from the program's start to
/// the first. `ends` of it means nothing.
[[nodiscard]] execution::PathFound path_on_from(const ProgramAnalysis& analysis, flow::NodeId from,
                                                flow::NodeId to);

} // namespace maclint::queries
