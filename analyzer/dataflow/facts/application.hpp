//! An operator or function that is applied to values.
#pragma once

#include "analyzer/dataflow/domain/value.hpp"
#include "analyzer/dataflow/facts/fact_set.hpp"
#include "analyzer/flow/graph.hpp"

namespace maclint::dataflow {

/// An operator or function of one or two operands that can be reached, of those that may have no value: most
/// of what a program calculates are sums.
struct Application {
    static constexpr FactPlace place{0};
    flow::NodeId node;
    EffectId effect;
    ExpressionId expression;
    Operation operation;
    ExpressionId left_expression;
    ExpressionId right_expression; ///< one operand: the same as left
    Value left;
    Value right; ///< one operand: the same as left
};

} // namespace maclint::dataflow
