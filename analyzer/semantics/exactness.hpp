//! Which results are whole numbers, and which are rounded: the facts are those of binary arithmetic.
#pragma once

#include "analyzer/semantics/abstract.hpp"

namespace maclint::semantics {

/// Whether the result is a whole number, for operands that `first` and `second` allow.
[[nodiscard]] bool gives_whole_numbers(Operation operation, const AbstractValue& first,
                                       const AbstractValue& second);
/// How exact the result is: `rounded` where an operand is, or where the operation may round it.
[[nodiscard]] Exactness exactness_of(Operation operation, const AbstractValue& first,
                                     const AbstractValue& second);
/// Whether the operation rounds whatever it is given: angles, roots, logarithms.
[[nodiscard]] bool always_rounds(Operation operation);

/// Whether sums of this value collect errors: it was rounded, or is a number that binary arithmetic cannot
/// hold.
[[nodiscard]] bool is_inexact(const AbstractValue& value);

} // namespace maclint::semantics
