//! An operator or function that is applied to values.
#pragma once

#include "analyzer/dataflow/value.hpp"
#include "analyzer/flow/graph.hpp"

namespace maclint::dataflow {

/// Whether there are operands for which the operation has no value.
[[nodiscard]] constexpr bool may_have_no_value(Operation operation) {
    switch (operation) {
    case Operation::divide:
    case Operation::modulo:
    case Operation::power:
    case Operation::tangent:
    case Operation::arc_sine:
    case Operation::arc_cosine:
    case Operation::arc_tangent_of_two:
    case Operation::square_root:
    case Operation::logarithm: return true;
    default: return false;
    }
}

/// An operator or function of one or two operands that can be reached, of those that may have no value: most
/// of what a program calculates are sums.
struct Application {
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
