//! Comparisons of ranges, and ranges cut by comparisons.
#include "analyzer/semantics/truth.hpp"

#include <algorithm>
#include <cmath>

namespace maclint::semantics {
namespace {

Truth equal(const AbstractValue& a, const AbstractValue& b, bool vacant_equals_zero) {
    Truth truth;
    const bool known = a.vacancy == Vacancy::set && b.vacancy == Vacancy::set;
    if (!vacant_equals_zero) {
        const auto one_vacant = [](const AbstractValue& x, const AbstractValue& y) {
            return x.vacancy == Vacancy::vacant && y.vacancy == Vacancy::set;
        };
        if (one_vacant(a, b) || one_vacant(b, a)) return {false, true};
    }
    if (a.high < b.low || b.high < a.low) truth.can_hold = false;
    const bool same_point = a.low == a.high && b.low == b.high && a.low == b.low;
    if (same_point && known && a.exactness == Exactness::exact && b.exactness == Exactness::exact)
        truth.can_fail = false;
    return truth;
}

Truth less(const Range& a, const Range& b) { return {a.low < b.high, a.high >= b.low}; }

/// Cuts the range of `value` to what the comparison with `other` leaves.
void cut(AbstractValue& value, Operation operation, const Range& other) {
    const auto above = [&](double bound) {
        return value.integer ? std::floor(bound) + 1 : std::nextafter(bound, bound + 1);
    };
    const auto below = [&](double bound) {
        return value.integer ? std::ceil(bound) - 1 : std::nextafter(bound, bound - 1);
    };
    switch (operation) {
    case Operation::equal:
        value.low = std::max(value.low, other.low);
        value.high = std::min(value.high, other.high);
        break;
    case Operation::not_equal:
        if (other.low != other.high || !std::isfinite(other.low)) break;
        if (other.low == 0) value.nonzero = true;
        if (value.low == other.low && value.high > value.low) value.low = above(other.low);
        if (value.high == other.low && value.high > value.low) value.high = below(other.low);
        break;
    case Operation::less:
        if (std::isfinite(other.high)) value.high = std::min(value.high, below(other.high));
        break;
    case Operation::less_equal: value.high = std::min(value.high, other.high); break;
    case Operation::greater:
        if (std::isfinite(other.low)) value.low = std::max(value.low, above(other.low));
        break;
    case Operation::greater_equal: value.low = std::max(value.low, other.low); break;
    default: break;
    }
}

/// Whether NE takes the other side's number away. It does not when vacant differs from 0 and that side may be
/// vacant, nor 0 from a value that may be: vacant passes NE 0 and counts as 0 afterwards.
bool excludes(const AbstractValue& value, const AbstractValue& other, bool vacant_equals_zero) {
    if (vacant_equals_zero) return true;
    return other.vacancy == Vacancy::set && (value.vacancy == Vacancy::set || other.low != 0);
}

} // namespace

Truth compare(Operation operation, const AbstractValue& left, const AbstractValue& right,
              bool vacant_equals_zero) {
    switch (operation) {
    case Operation::equal: return equal(left, right, vacant_equals_zero);
    case Operation::not_equal: return negated(equal(left, right, vacant_equals_zero));
    case Operation::less: return less(left, right);
    case Operation::greater: return less(right, left);
    case Operation::less_equal: return negated(less(right, left));
    case Operation::greater_equal: return negated(less(left, right));
    default: return {};
    }
}

Truth compare_with_itself(Operation operation) {
    switch (operation) {
    case Operation::equal:
    case Operation::less_equal:
    case Operation::greater_equal: return {true, false};
    case Operation::not_equal:
    case Operation::less:
    case Operation::greater: return {false, true};
    default: return {};
    }
}

Truth test_vacancy(Operation operation, const AbstractValue& operand) {
    const Truth vacant{operand.vacancy != Vacancy::set, operand.vacancy != Vacancy::vacant};
    return operation == Operation::is_vacant ? vacant : negated(vacant);
}

std::optional<AbstractValue> refine(const AbstractValue& value, Operation operation,
                                    const AbstractValue& other, bool vacant_equals_zero) {
    AbstractValue left = value;
    // EQ tells a number from vacant; the other comparisons take vacant for 0 [MITSU-326].
    if (operation == Operation::equal && other.vacancy == Vacancy::set && !vacant_equals_zero)
        left.vacancy = Vacancy::set;
    if (left.vacancy != Vacancy::set && operation != Operation::not_equal) {
        AbstractValue zero;
        zero.low = zero.high = 0;
        cut(zero, operation, other);
        if (zero.low > zero.high) left.vacancy = Vacancy::set;
    }
    if (operation != Operation::not_equal || excludes(left, other, vacant_equals_zero))
        cut(left, operation, other);
    if (left.low > left.high) return std::nullopt;
    return left;
}

Operation opposite(Operation operation) {
    switch (operation) {
    case Operation::equal: return Operation::not_equal;
    case Operation::not_equal: return Operation::equal;
    case Operation::less: return Operation::greater_equal;
    case Operation::less_equal: return Operation::greater;
    case Operation::greater: return Operation::less_equal;
    case Operation::greater_equal: return Operation::less;
    case Operation::is_vacant: return Operation::is_set;
    case Operation::is_set: return Operation::is_vacant;
    default: return operation;
    }
}

Operation mirrored(Operation operation) {
    switch (operation) {
    case Operation::less: return Operation::greater;
    case Operation::less_equal: return Operation::greater_equal;
    case Operation::greater: return Operation::less;
    case Operation::greater_equal: return Operation::less_equal;
    default: return operation;
    }
}

} // namespace maclint::semantics
