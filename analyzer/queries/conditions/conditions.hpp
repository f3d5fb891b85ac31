//! What expressions and conditions say.
#pragma once

#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>

namespace maclint::queries {

/// The variable that the expression is, and nothing else.
[[nodiscard]] std::optional<Variable> plain_variable(const Program& program, ExpressionId expression);

/// Whether the two say the same, brackets aside.
[[nodiscard]] bool same_expression(const Program& program, ExpressionId a, ExpressionId b);

/// Whether the condition holds a vacancy test of whatever.
[[nodiscard]] bool tests_any_vacancy(const Program& program, ExpressionId expression);

/// Whether a comparison in one of the nodes from `first` to `last` tests the variable for vacancy.
[[nodiscard]] bool asks_for_vacancy(const Program& program, const dataflow::Facts& facts, flow::NodeId first,
                                    flow::NodeId last, Variable variable);

/// Whether the expression stands in a later part of a condition of AND or OR: nobody knows whether a control
/// still computes it once an earlier part has decided.
[[nodiscard]] bool may_be_left_out(const Program& program, const dataflow::Facts& facts, EffectId effect,
                                   ExpressionId expression);

/// The comparison with 0, by EQ or NE, that the read is a side of; nullptr when it is in none.
[[nodiscard]] const dataflow::Comparison* zero_test_of(const ProgramAnalysis& analysis,
                                                       const dataflow::Read& read);

} // namespace maclint::queries
