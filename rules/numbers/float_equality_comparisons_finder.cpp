//! Asks where the values of both sides come from.
#include "rules/numbers/float_equality_comparisons_finder.hpp"

#include "analyzer/program/tables.hpp"
#include "analyzer/queries/conditions/conditions.hpp"
#include "analyzer/queries/values/calculations.hpp"
#include "analyzer/queries/values/copies.hpp"

namespace maclint::rules {
namespace {

using dataflow::Value;

bool is_rounded(const Value& value) {
    return value.exactness == dataflow::Exactness::rounded && !queries::is_as_written(value);
}

/// Whether a number is whole: x EQ FIX[x]. Of a quotient only where it is divided by a whole number: 0.3/0.1
/// is not 3.
bool asks_for_whole(const ProgramAnalysis& analysis, const Value& left, const Value& right) {
    const auto asks = [&](const Value& rounded, const Value& of) {
        return queries::is_rounded_result(analysis, rounded, of) &&
               !queries::is_quotient_of_decimals(analysis, of);
    };
    return asks(left, right) || asks(right, left);
}

bool is_safe_against_zero(const ProgramAnalysis& analysis, const Value& value, const Value& zero) {
    return zero.constant() == 0.0 && queries::operation_of(analysis, value) &&
           queries::is_zero_as_on_paper(analysis, value);
}

/// IF[#14GT#2]THEN#14=#2 … IF[#14EQ#2]
bool is_copy_asked_for(const ProgramAnalysis& analysis, ExpressionId expression, const Value& other) {
    const auto variable = queries::plain_variable(analysis.program(), expression);
    return variable && queries::is_copied_into(analysis, *variable, other);
}

/// ABS[a-b] EQ 0: somebody who asks for a distance knows that the two are hardly ever equal.
bool is_distance_to_nothing(const ProgramAnalysis& analysis, const Value& value, const Value& zero) {
    return zero.constant() == 0.0 && !value.integer && queries::is_distance(analysis, value);
}

/// `#5063EQ#1`, where the program has calculated #1.
bool is_touch_on_calculated_place(const ProgramAnalysis& analysis, ExpressionId side,
                                  const dataflow::Value& other) {
    const auto* machine = std::get_if<LoadMachine>(&analysis.program().expressions[side].node);
    const VariableRange* range =
        machine == nullptr ? nullptr : analysis.control().families[machine->family].find(machine->number);
    return range != nullptr && range->is_skip_position &&
           analysis.data().table().symbols[other.symbol].kind() == dataflow::Symbol::Kind::result;
}

} // namespace

std::optional<InexactSide> inexact_side(const ProgramAnalysis& analysis, const Sums& sums,
                                        const dataflow::Comparison& comparison) {
    using Why = InexactSide::Why;
    if (!is_decided_exactly(analysis, comparison)) {
        if (is_rounded(comparison.left))
            return InexactSide{comparison.left_expression, Why::rounded, comparison.left.rounding};
        if (is_rounded(comparison.right))
            return InexactSide{comparison.right_expression, Why::rounded, comparison.right.rounding};
        for (const ExpressionId side : {comparison.left_expression, comparison.right_expression})
            if (const dataflow::Store* sum = sum_in(analysis, sums, side))
                return InexactSide{side, Why::sum, 0, sum};
    }
    if (is_distance_to_nothing(analysis, comparison.left, comparison.right))
        return InexactSide{comparison.left_expression, Why::distance};
    if (is_distance_to_nothing(analysis, comparison.right, comparison.left))
        return InexactSide{comparison.right_expression, Why::distance};
    if (is_touch_on_calculated_place(analysis, comparison.left_expression, comparison.right))
        return InexactSide{comparison.left_expression, Why::touched};
    if (is_touch_on_calculated_place(analysis, comparison.right_expression, comparison.left))
        return InexactSide{comparison.right_expression, Why::touched};
    return std::nullopt;
}

bool is_decided_exactly(const ProgramAnalysis& analysis, const dataflow::Comparison& c) {
    return queries::is_same_value(c.left, c.right) || queries::are_rounded_alike(analysis, c.left, c.right) ||
           (exemptions::whole_number_asked_for.is_on() && asks_for_whole(analysis, c.left, c.right)) ||
           is_safe_against_zero(analysis, c.left, c.right) ||
           is_safe_against_zero(analysis, c.right, c.left) ||
           (exemptions::copy_asked_for.is_on() && (is_copy_asked_for(analysis, c.left_expression, c.right) ||
                                                   is_copy_asked_for(analysis, c.right_expression, c.left)));
}

} // namespace maclint::rules
