//! What comparisons and vacancy tests can turn out to be, and what is known once they have.
#pragma once

#include "analyzer/semantics/abstract.hpp"

#include <optional>

namespace maclint::semantics {

/// What a condition can turn out to be.
struct Truth {
    bool can_hold = true;
    bool can_fail = true;
};
[[nodiscard]] constexpr Truth negated(Truth truth) { return {truth.can_fail, truth.can_hold}; }

/// The outcome of EQ, NE, LT … for two values that have nothing to do with each other;
/// `vacant_equals_zero` is the control's.
[[nodiscard]] Truth compare(Operation operation, const AbstractValue& left, const AbstractValue& right,
                            bool vacant_equals_zero);
/// The outcome where both sides are the same value, whatever it is.
[[nodiscard]] Truth compare_with_itself(Operation operation);
/// The outcome of `is_vacant` or `is_set`.
[[nodiscard]] Truth test_vacancy(Operation operation, const AbstractValue& operand);

/// What `value` can still be where its comparison with `other` is true; nothing: it cannot be true.
[[nodiscard]] std::optional<AbstractValue> refine(const AbstractValue& value, Operation operation,
                                                  const AbstractValue& other, bool vacant_equals_zero);

/// LT for GE and so on; what holds when the comparison or vacancy test fails.
[[nodiscard]] Operation opposite(Operation operation);
/// GT for LT and so on; the same comparison with its sides exchanged.
[[nodiscard]] Operation mirrored(Operation operation);

} // namespace maclint::semantics
