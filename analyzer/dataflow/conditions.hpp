//! Questions about expressions and conditions that more than one rule asks.
#pragma once

#include "analyzer/dataflow/facts.hpp"
#include "analyzer/flow/graph.hpp"

#include <optional>
#include <span>

namespace maclint::dataflow {

/// The variable that the expression is, and nothing else.
[[nodiscard]] std::optional<Variable> plain_variable(const Program& program, ExpressionId expression);

/// The variables that an expression reads.
struct ReadSet {
    std::vector<Variable> variables;
    bool closed; ///< nothing but `variables` and constants decides the value
};
[[nodiscard]] ReadSet variables_of(const Program& program, ExpressionId expression);

/// Whether vacant is a value that the variable can be given and asked for; otherwise a variable that nothing
/// has set is undefined.
[[nodiscard]] bool may_hold_vacant(const Program& program, Variable variable);

/// Whether the two say the same, brackets aside.
[[nodiscard]] bool same_expression(const Program& program, ExpressionId a, ExpressionId b);

/// Whether the condition holds a vacancy test of whatever.
[[nodiscard]] bool tests_any_vacancy(const Program& program, ExpressionId expression);

/// Whether one of the nodes from `first` to `last` tests the variable for vacancy.
[[nodiscard]] bool asks_for_vacancy(const Program& program, const Facts& facts, flow::NodeId first,
                                    flow::NodeId last, Variable variable);

/// Whether the expression stands in a later part of a condition of AND or OR: nobody knows whether a control
/// still computes it once an earlier part has decided.
[[nodiscard]] bool may_be_left_out(const Program& program, const Facts& facts, EffectId effect,
                                   ExpressionId expression);

/// How a condition turned out on a path.
struct Decision {
    ExpressionId condition;
    bool holds;
};

/// The first decision that contradicts an earlier one: #1EQ50 held, and later #1NE50 held. What may have
/// changed in between is not looked at.
[[nodiscard]] std::optional<std::size_t> first_contradiction(const Program& program,
                                                             std::span<const Decision> decisions);

} // namespace maclint::dataflow
