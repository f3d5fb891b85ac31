//! What the failure of a search depends on: the reasons why no path leads on from a place.
#pragma once

#include "analyzer/dataflow/solver/summary.hpp"
#include "analyzer/dataflow/solver/variable_sets.hpp"
#include "analyzer/execution/search_work.hpp"
#include "analyzer/flow/graph.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace maclint::execution {

using dataflow::VariableSet;

/// The variables on which a failure depended. Where they hold the same again, the search fails again and need
/// not be made.
class FailureReasons {
  public:
    /// The references must outlive the reasons.
    FailureReasons(const Program& program, const flow::Graph& graph, const dataflow::Callees& callees,
                   SearchWork& work)
        : program_(program)
        , graph_(graph)
        , callees_(callees)
        , sets_(program, graph)
        , work_(work) {}

    [[nodiscard]] VariableSet none() const;
    [[nodiscard]] std::vector<Variable> members(const VariableSet& set) const;
    void add_all(VariableSet& to, const VariableSet& from) const;
    /// Adds what is asked at the edge.
    void add_decision(const flow::Edge& edge, VariableSet& set) const;
    /// What decides whether the programs that the node calls come back. Arguments seldom differ from path to
    /// path.
    void add_returns(flow::NodeId node, VariableSet& set) const;
    /// From after the node to before it: what a variable holds is asked of what was stored in it.
    void go_back_over(flow::NodeId node, VariableSet& set) const;

  private:
    [[nodiscard]] std::size_t size_of(ExpressionId id) const;
    void add_reads(std::optional<ExpressionId> id, VariableSet& set) const;

    const Program& program_;
    const flow::Graph& graph_;
    const dataflow::Callees& callees_;
    dataflow::VariableSets sets_;
    SearchWork& work_;
};

} // namespace maclint::execution
