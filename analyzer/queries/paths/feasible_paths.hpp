//! Paths through a program that somebody can go: around every assignment to a variable, or from one node to
//! another.
#pragma once

#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/dataflow/loops.hpp"
#include "analyzer/execution/path_search.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace maclint::queries {

/// Which nodes a path leads to on which no assignment to a variable stands; whether the control can take the
/// path is not asked. Many questions about one variable cost one walk.
class WithoutAssignment {
  public:
    explicit WithoutAssignment(const ProgramAnalysis& analysis)
        : analysis_(analysis) {}

    /// Whether a path leads from the program's start to the node.
    [[nodiscard]] bool leads_to(Variable variable, flow::NodeId node);
    /// Somebody has found out that no path of this kind does: nor does one lead over the node.
    void exclude(Variable variable, flow::NodeId node);

  private:
    struct Reach {
        std::vector<flow::NodeId> excluded;
        std::vector<bool> nodes; ///< to which a path leads; empty: not asked since a node was excluded
    };
    [[nodiscard]] std::vector<bool> reach_of(Variable variable, const Reach& reach) const;

    const ProgramAnalysis& analysis_;
    std::unordered_map<Variable, Reach, VariableHash> reach_;
};

/// The nodes at which the variable may get another value, sorted; without `except`.
[[nodiscard]] std::vector<flow::NodeId> nodes_that_may_change(const ProgramAnalysis& analysis,
                                                              Variable variable, flow::NodeId except);

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
