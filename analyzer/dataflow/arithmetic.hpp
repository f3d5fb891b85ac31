//! What operators and functions do to values: range, whole numbers, rounding.
#pragma once

#include "analyzer/dataflow/value.hpp"
#include "analyzer/semantics/concrete.hpp"

#include <span>

namespace maclint::dataflow {

/// What a condition can turn out to be.
struct Truth {
    bool can_hold = true;
    bool can_fail = true;
};

/// The result of an operator or function. `here` is the expression, for values that are rounded by it.
[[nodiscard]] Value compute(ValueTable& table, Operation operation, std::span<const Value> operands,
                            const Origin& here);

/// The outcome of a comparison or vacancy test; `vacant_equals_zero` is the control's.
[[nodiscard]] Truth compare(Operation operation, const Value& left, const Value& right,
                            bool vacant_equals_zero);
[[nodiscard]] Truth test_vacancy(Operation operation, const Value& operand);

/// Whether sums of this value collect errors: it was rounded, or is a number that binary arithmetic cannot
/// hold.
[[nodiscard]] bool is_inexact(const Value& value);

using semantics::is_comparison;
/// LT for GE and so on; what holds when the comparison fails.
[[nodiscard]] Operation opposite(Operation operation);
/// GT for LT and so on; the same comparison with its sides exchanged.
[[nodiscard]] Operation mirrored(Operation operation);

} // namespace maclint::dataflow
