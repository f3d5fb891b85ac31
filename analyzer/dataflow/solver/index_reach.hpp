//! Which variables a store through an index may mean.
#pragma once

#include "analyzer/flow/graph.hpp"
#include "analyzer/program/model.hpp"
#include "analyzer/semantics/range.hpp"

#include <optional>
#include <unordered_map>
#include <vector>

namespace maclint::dataflow {

/// The numbers that an index may be.
struct IndexReach {
    semantics::Range numbers;
    bool locals = true; ///< those of local variables, too
};

/// What the indices of one program reach.
class IndexReaches {
  public:
    IndexReaches(const Program& program, const flow::Graph& graph)
        : program_(program)
        , graph_(graph) {}

    /// `known` is the range of the index, which stands in the node. Where that has no end on one side, the
    /// custom of the family's programmers (IndexCustom) counts as well.
    [[nodiscard]] IndexReach of(FamilyId family, ExpressionId index, const semantics::Range& known,
                                flow::NodeId node);

  private:
    /// A variable that assignments set, and the least number in the sums that they store; steps left
    /// out. 0 where a block may set it that nobody can read.
    struct Base {
        Variable variable;
        double number;
    };

    void collect_bases();
    /// The least number that the variable has in the index, which stands in the node; 0: nothing is known.
    [[nodiscard]] double base_of(Variable variable, ExpressionId index, flow::NodeId node);
    /// Whether a path leads there on which the variable still has what a call has passed.
    [[nodiscard]] bool may_be_passed(Variable variable, ExpressionId index, flow::NodeId node);
    /// Whether the node stores into the variable, in front of the place.
    [[nodiscard]] bool sets(flow::NodeId node, Variable variable, Offset before) const;

    const Program& program_;
    const flow::Graph& graph_;
    std::optional<std::vector<Base>> bases_; ///< sorted; nothing: nobody has asked
    /// For variables that were asked for: the nodes that begin with what a call has passed.
    std::unordered_map<Variable, std::vector<bool>, VariableHash> passed_;
};

} // namespace maclint::dataflow
