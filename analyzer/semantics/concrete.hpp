//! What operators, functions and comparisons do to numbers and to vacancy: for the stepper, for constants of
//! the solver, and as the measure of abstract.hpp in tests.
#pragma once

#include "analyzer/program/model.hpp"

#include <optional>
#include <span>
#include <variant>

namespace maclint::semantics {

/// What a variable holds; nothing: it is vacant.
using Content = std::optional<double>;

/// No result: the control stops with an alarm (112 for a divisor of 0, 111 and 119 for operands outside of
/// what a function takes).
struct DomainError {};
/// The model does not say what comes out.
struct NotModelled {};
using Result = std::variant<double, DomainError, NotModelled>;

/// The result of an operator or function on numbers; vacant operands count as 0. Comparisons and logic
/// between conditions give no number.
[[nodiscard]] Result compute(Operation operation, std::span<const double> operands);
[[nodiscard]] Result compute(Operation operation, std::span<const Content> operands);

/// Whether a variable can hold the number.
[[nodiscard]] bool is_in_range(double number);

/// What a variable of the type holds after the number was stored there.
[[nodiscard]] double stored_in(VariableType type, double number);

/// EQ, NE, LT …; `vacant_equals_zero` is the control's.
[[nodiscard]] bool compare(Operation operation, Content left, Content right, bool vacant_equals_zero);
/// Whether `is_vacant` or `is_set` is true.
[[nodiscard]] bool test_vacancy(Operation operation, Content operand);

[[nodiscard]] constexpr bool is_comparison(Operation operation) {
    return operation >= Operation::equal && operation <= Operation::greater_equal;
}
/// Whether it asks for less or more.
[[nodiscard]] constexpr bool is_order(Operation operation) {
    return operation == Operation::less || operation == Operation::less_equal ||
           operation == Operation::greater || operation == Operation::greater_equal;
}
[[nodiscard]] constexpr bool is_vacancy_test(Operation operation) {
    return operation == Operation::is_vacant || operation == Operation::is_set;
}

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

/// The number of a variable that an index means: a fraction is rounded [SINHA-INT].
[[nodiscard]] std::optional<std::int32_t> variable_number(double index);

} // namespace maclint::semantics
