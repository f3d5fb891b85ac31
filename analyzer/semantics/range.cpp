//! Interval arithmetic.
#include "analyzer/semantics/range.hpp"

#include "analyzer/semantics/concrete.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <span>
#include <variant>

namespace maclint::semantics {
namespace {

Range hull(std::initializer_list<double> ends) {
    Range range{infinity, -infinity};
    for (const double end : ends) {
        if (std::isnan(end)) return {};
        range.low = std::min(range.low, end);
        range.high = std::max(range.high, end);
    }
    return range;
}

/// 0 times anything is 0, also times a bound that is not known.
double product(double a, double b) { return a == 0 || b == 0 ? 0 : a * b; }

Range multiply(const Range& a, const Range& b) {
    return hull(
        {product(a.low, b.low), product(a.low, b.high), product(a.high, b.low), product(a.high, b.high)});
}

Range divide(const Range& a, const Range& b) {
    if (b.low <= 0 && b.high >= 0) return {};
    const auto quotient = [](double x, double y) { return std::isinf(y) ? 0 : x / y; };
    return hull(
        {quotient(a.low, b.low), quotient(a.low, b.high), quotient(a.high, b.low), quotient(a.high, b.high)});
}

Range absolute(const Range& a) {
    if (a.low >= 0) return a;
    if (a.high <= 0) return {-a.high, -a.low};
    return {0, std::max(-a.low, a.high)};
}

/// What a function that grows with its operand does to both ends.
Range at_both_ends(Operation operation, const Range& range) {
    const auto at = [&](double end) {
        const Result result = compute(operation, std::span<const double>(&end, 1));
        const auto* number = std::get_if<double>(&result);
        return number == nullptr ? std::nan("") : *number;
    };
    return hull({at(range.low), at(range.high)});
}

} // namespace

Range range_of(Operation operation, const Range& first, const Range& second) {
    switch (operation) {
    case Operation::add: return hull({first.low + second.low, first.high + second.high});
    case Operation::subtract: return hull({first.low - second.high, first.high - second.low});
    case Operation::multiply: return multiply(first, second);
    case Operation::divide: return divide(first, second);
    case Operation::negate: return {-first.high, -first.low};
    case Operation::absolute: return absolute(first);
    case Operation::round:
    case Operation::truncate:
    case Operation::round_up: return at_both_ends(operation, first);
    case Operation::square_root: return first.low < 0 ? Range{0, infinity} : at_both_ends(operation, first);
    case Operation::sine:
    case Operation::cosine: return {-1, 1};
    case Operation::exponential: return {0, infinity};
    case Operation::modulo: return first.low >= 0 && second.low > 0 ? Range{0, second.high} : Range{};
    default: return {};
    }
}

} // namespace maclint::semantics
