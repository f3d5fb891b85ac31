//! Asks where the values of both sides come from.
#include "analyzer/queries/inexact_comparisons.hpp"

#include "analyzer/queries/calculations.hpp"
#include "analyzer/queries/conditions.hpp"
#include "analyzer/queries/copies.hpp"

namespace maclint::queries {
namespace {

using dataflow::Value;

/// Whether a number is whole: x EQ FIX[x].
bool asks_for_whole(const ProgramAnalysis& analysis, const Value& left, const Value& right) {
    return is_rounded_result(analysis, left, right) || is_rounded_result(analysis, right, left);
}

/// Products and quotients are 0 exactly when an operand is.
bool is_safe_against_zero(const ProgramAnalysis& analysis, const Value& value, const Value& zero) {
    if (zero.constant() != 0.0) return false;
    const auto operation = operation_of(analysis, value);
    return operation == Operation::multiply || operation == Operation::divide;
}

/// IF[#14GT#2]THEN#14=#2 … IF[#14EQ#2]
bool is_copy_asked_for(const ProgramAnalysis& analysis, ExpressionId expression, const Value& other) {
    const auto variable = plain_variable(analysis.program(), expression);
    return variable && is_copied_into(analysis, *variable, other);
}

} // namespace

std::optional<InexactSide> inexact_side(const ProgramAnalysis& analysis, const Sums& sums,
                                        const dataflow::Comparison& comparison) {
    if (comparison.left.exactness == dataflow::Exactness::rounded)
        return InexactSide{comparison.left_expression, comparison.left.rounding, nullptr};
    if (comparison.right.exactness == dataflow::Exactness::rounded)
        return InexactSide{comparison.right_expression, comparison.right.rounding, nullptr};
    for (const ExpressionId side : {comparison.left_expression, comparison.right_expression})
        if (const dataflow::Store* sum = sum_in(analysis, sums, side)) return InexactSide{side, 0, sum};
    return std::nullopt;
}

bool is_decided_exactly(const ProgramAnalysis& analysis, const dataflow::Comparison& c) {
    return is_same_value(c.left, c.right) || asks_for_whole(analysis, c.left, c.right) ||
           is_safe_against_zero(analysis, c.left, c.right) ||
           is_safe_against_zero(analysis, c.right, c.left) ||
           is_copy_asked_for(analysis, c.left_expression, c.right) ||
           is_copy_asked_for(analysis, c.right_expression, c.left);
}

} // namespace maclint::queries
