//! Range, vacancy, whole numbers and exactness together.
#include "analyzer/semantics/abstract.hpp"

#include "analyzer/semantics/concrete.hpp"
#include "analyzer/semantics/exactness.hpp"

#include <algorithm>
#include <cmath>

namespace maclint::semantics {
namespace {

Vacancy join(Vacancy a, Vacancy b) {
    if (a == b) return a;
    const bool evidence =
        a == Vacancy::maybe || b == Vacancy::maybe || a == Vacancy::vacant || b == Vacancy::vacant;
    return evidence ? Vacancy::maybe : Vacancy::unknown;
}

} // namespace

AbstractValue of_number(double number) {
    return {{number, number}, Vacancy::set, Exactness::exact, std::floor(number) == number};
}

/// The number is what arithmetic and comparisons other than EQ and NE take it for.
AbstractValue of_vacant() { return {{0, 0}, Vacancy::vacant, Exactness::exact, true}; }

AbstractValue compute(Operation operation, const AbstractValue& first, const AbstractValue& second) {
    AbstractValue result{range_of(operation, first, second)};
    result.vacancy = Vacancy::set; // arithmetic takes vacant for 0 [MITSU-326]
    result.integer = gives_whole_numbers(operation, first, second);
    result.exactness = exactness_of(operation, first, second);
    if (is_whole_number(result)) return of_number(result.low);
    if (operation == Operation::negate || operation == Operation::absolute) result.nonzero = !first.can_be(0);
    return result;
}

bool is_whole_number(const AbstractValue& value) {
    return value.low == value.high && std::isfinite(value.low) && std::floor(value.low) == value.low &&
           value.exactness == Exactness::exact;
}

AbstractValue stored_in(VariableType type, const AbstractValue& value) {
    if (type == VariableType::number || type == VariableType::text || value.vacancy == Vacancy::vacant)
        return value;
    if (const auto number = value.constant(); number && !fits(type, value))
        return of_number(stored_in(type, *number));
    AbstractValue held = value;
    held.integer = true;
    held.exactness = Exactness::exact;
    if (fits(type, value)) return held;
    held.low = type == VariableType::truth ? 0 : std::round(value.low);
    held.high = type == VariableType::truth ? 1 : std::round(value.high);
    held.nonzero = false;
    return held;
}

bool fits(VariableType type, const AbstractValue& value) {
    if (type == VariableType::number || type == VariableType::text) return true;
    if (const auto number = value.constant()) return stored_in(type, *number) == *number;
    return value.integer && (type == VariableType::integer || (value.low >= 0 && value.high <= 1));
}

AbstractValue join(const AbstractValue& a, const AbstractValue& b) {
    return {{std::min(a.low, b.low), std::max(a.high, b.high)},
            join(a.vacancy, b.vacancy),
            std::max(a.exactness, b.exactness),
            a.integer && b.integer,
            !a.can_be(0) && !b.can_be(0)};
}

bool keeps_zero(Operation operation) {
    switch (operation) {
    case Operation::negate:
    case Operation::absolute:
    case Operation::multiply:
    case Operation::round:
    case Operation::truncate:
    case Operation::round_up:
    case Operation::add_point: return true;
    default: return false;
    }
}

bool is_commutative(Operation operation) {
    switch (operation) {
    case Operation::add:
    case Operation::multiply:
    case Operation::bit_and:
    case Operation::bit_or:
    case Operation::bit_xor: return true;
    default: return false;
    }
}

} // namespace maclint::semantics
