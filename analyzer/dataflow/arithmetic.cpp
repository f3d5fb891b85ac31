//! Interval arithmetic with a table of what each operation does to whole and exact numbers.
#include "analyzer/dataflow/arithmetic.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace maclint::dataflow {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Range {
    double low, high;
};

Range hull(std::initializer_list<double> ends) {
    Range range{infinity, -infinity};
    for (const double end : ends) {
        if (std::isnan(end)) return {-infinity, infinity};
        range.low = std::min(range.low, end);
        range.high = std::max(range.high, end);
    }
    return range;
}

/// 0 times anything is 0, also times a bound that is not known.
double product(double a, double b) { return a == 0 || b == 0 ? 0 : a * b; }

Range multiply(const Value& a, const Value& b) {
    return hull(
        {product(a.low, b.low), product(a.low, b.high), product(a.high, b.low), product(a.high, b.high)});
}

Range divide(const Value& a, const Value& b) {
    if (b.low <= 0 && b.high >= 0) return {-infinity, infinity};
    const auto quotient = [](double x, double y) { return std::isinf(y) ? 0 : x / y; };
    return hull(
        {quotient(a.low, b.low), quotient(a.low, b.high), quotient(a.high, b.low), quotient(a.high, b.high)});
}

Range absolute(const Value& a) {
    if (a.low >= 0) return {a.low, a.high};
    if (a.high <= 0) return {-a.high, -a.low};
    return {0, std::max(-a.low, a.high)};
}

/// What a function that grows with its operand does to both ends.
Range at_both_ends(Operation operation, const Value& value) {
    const auto at = [&](double end) {
        const semantics::Result result = semantics::compute(operation, std::span<const double>(&end, 1));
        const auto* number = std::get_if<double>(&result);
        return number == nullptr ? std::nan("") : *number;
    };
    return hull({at(value.low), at(value.high)});
}

Range range_of(Operation operation, std::span<const Value> v) {
    switch (operation) {
    case Operation::add: return hull({v[0].low + v[1].low, v[0].high + v[1].high});
    case Operation::subtract: return hull({v[0].low - v[1].high, v[0].high - v[1].low});
    case Operation::multiply: return multiply(v[0], v[1]);
    case Operation::divide: return divide(v[0], v[1]);
    case Operation::negate: return {-v[0].high, -v[0].low};
    case Operation::absolute: return absolute(v[0]);
    case Operation::round:
    case Operation::truncate:
    case Operation::round_up: return at_both_ends(operation, v[0]);
    case Operation::square_root: return v[0].low < 0 ? Range{0, infinity} : at_both_ends(operation, v[0]);
    case Operation::sine:
    case Operation::cosine: return {-1, 1};
    case Operation::exponential: return {0, infinity};
    case Operation::modulo:
        return v[0].low >= 0 && v[1].low > 0 ? Range{0, v[1].high} : Range{-infinity, infinity};
    default: return {-infinity, infinity};
    }
}

/// What an operation does to whole numbers and to rounding; the facts are those of binary arithmetic.
struct Semantics {
    Operation operation;
    enum class Whole : std::uint8_t { never, if_operands, if_exponent_too, always } whole;
    enum class Rounds : std::uint8_t { never, unless_whole, always, by_divisor, havocs } rounds;
};

using W = Semantics::Whole;
using R = Semantics::Rounds;

// Sources: macro reference, section 3 (functions and logic on whole numbers), SEED-001:306-332 (rounding).
constexpr auto semantics = std::to_array<Semantics>({
    {Operation::add, W::if_operands, R::unless_whole},
    {Operation::subtract, W::if_operands, R::unless_whole},
    {Operation::multiply, W::if_operands, R::unless_whole},
    {Operation::divide, W::never, R::by_divisor},
    {Operation::modulo, W::if_operands, R::unless_whole},
    {Operation::power, W::if_exponent_too, R::unless_whole},
    {Operation::negate, W::if_operands, R::never},
    {Operation::absolute, W::if_operands, R::never},
    {Operation::bit_and, W::always, R::havocs},
    {Operation::bit_or, W::always, R::havocs},
    {Operation::bit_xor, W::always, R::havocs},
    {Operation::bit_not, W::always, R::havocs},
    {Operation::round, W::always, R::havocs},
    {Operation::truncate, W::always, R::havocs},
    {Operation::round_up, W::always, R::havocs},
    {Operation::to_binary, W::always, R::havocs},
    {Operation::to_decimal_code, W::always, R::havocs},
    {Operation::add_point, W::never, R::never},
    {Operation::sine, W::never, R::always},
    {Operation::cosine, W::never, R::always},
    {Operation::tangent, W::never, R::always},
    {Operation::arc_sine, W::never, R::always},
    {Operation::arc_cosine, W::never, R::always},
    {Operation::arc_tangent, W::never, R::always},
    {Operation::arc_tangent_of_two, W::never, R::always},
    {Operation::square_root, W::never, R::always},
    {Operation::logarithm, W::never, R::always},
    {Operation::exponential, W::never, R::always},
});

const Semantics* find_semantics(Operation operation) {
    const auto found = std::ranges::find(semantics, operation, &Semantics::operation);
    return found == semantics.end() ? nullptr : &*found;
}

/// A fraction with few binary digits: sums of such numbers are exact.
bool is_dyadic(double number) {
    constexpr double grid = 1024;
    return std::abs(number) < 1e9 && std::floor(number * grid) == number * grid;
}

/// Operations whose result is 0 when an operand is.
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

OriginId vacancy_origin_of(std::span<const Value> v) {
    const auto doubtful = std::ranges::find_if(
        v, [](const Value& value) { return value.vacancy_origin != 0 && value.can_be(0); });
    return doubtful == v.end() ? 0 : doubtful->vacancy_origin;
}

bool all_whole(std::span<const Value> v) {
    return std::ranges::all_of(v, [](const Value& value) { return value.integer; });
}

bool is_whole(W whole, std::span<const Value> v) {
    switch (whole) {
    case W::never: return false;
    case W::if_operands: return all_whole(v);
    case W::if_exponent_too: return all_whole(v) && v[1].low >= 0; // POW[2,-1] is 0.5
    case W::always: return true;
    }
    return false;
}

bool is_power_of_two(double number) {
    int exponent = 0;
    return number != 0 && std::isfinite(number) && std::abs(std::frexp(number, &exponent)) == 0.5;
}

/// A number written with decimals that binary arithmetic cannot hold: 0.1.
bool is_inexact_constant(const Value& value) { return value.low == value.high && !is_dyadic(value.low); }

Exactness worst(std::span<const Value> v) {
    Exactness result = Exactness::exact;
    for (const Value& value : v) result = std::max(result, value.exactness);
    return result;
}

Exactness division(std::span<const Value> v) {
    if (const auto divisor = v[1].constant(); divisor && *divisor != 0) {
        if (is_power_of_two(*divisor)) return v[0].exactness;
        if (const auto dividend = v[0].constant(); dividend && is_dyadic(*dividend / *divisor))
            return worst(v);
    }
    return Exactness::rounded;
}

Exactness sum_or_product(std::span<const Value> v) {
    const Exactness operands = worst(v);
    if (operands == Exactness::rounded || all_whole(v)) return operands;
    if (std::ranges::any_of(v, is_inexact_constant)) return Exactness::rounded;
    const bool dyadic = std::ranges::all_of(
        v, [](const Value& x) { return x.integer || (x.low == x.high && is_dyadic(x.low)); });
    return dyadic ? operands : std::max(operands, Exactness::unknown);
}

Exactness exactness_of(R rounds, std::span<const Value> v) {
    switch (rounds) {
    case R::never: return worst(v);
    case R::unless_whole: return sum_or_product(v);
    case R::always: return Exactness::rounded;
    case R::by_divisor: return division(v);
    case R::havocs: return Exactness::exact;
    }
    return Exactness::unknown;
}

/// a+b and b+a are one value.
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

Symbol symbol_of(Operation operation, std::span<const Value> v, const Origin& here) {
    const bool fits = !v.empty() && v.size() <= 2 && operation != Operation::unknown;
    if (!fits) return {Symbol::Kind::opaque, here.id, 1, here.node};
    SymbolId first = v[0].symbol;
    SymbolId second = v.size() < 2 ? 0 : v[1].symbol;
    if (is_commutative(operation) && second < first) std::swap(first, second);
    return {Symbol::Kind::result, static_cast<std::uint64_t>(operation), first, second};
}

} // namespace

Value compute(ValueTable& table, Operation operation, std::span<const Value> operands, const Origin& here) {
    Value result;
    result.vacancy = Vacancy::set; // arithmetic takes vacant for 0 [MITSU-326]
    const Semantics* row = find_semantics(operation);
    const Range range = row == nullptr ? Range{-infinity, infinity} : range_of(operation, operands);
    result.low = range.low;
    result.high = range.high;
    if (row != nullptr) {
        result.integer = is_whole(row->whole, operands);
        result.exactness = exactness_of(row->rounds, operands);
        if (result.exactness == Exactness::rounded) {
            const auto rounded = std::ranges::find(operands, Exactness::rounded, &Value::exactness);
            result.rounding = rounded != operands.end() && row->rounds != R::always ? rounded->rounding
                                                                                    : table.origins(here);
        }
    }
    if (result.low == result.high && std::isfinite(result.low) && std::floor(result.low) == result.low &&
        result.exactness == Exactness::exact) {
        return number_value(table, result.low);
    }
    if (keeps_zero(operation)) result.vacancy_origin = vacancy_origin_of(operands);
    if (operation == Operation::negate || operation == Operation::absolute)
        result.nonzero = !operands[0].can_be(0);
    result.symbol = table.symbols(symbol_of(operation, operands, here));
    return result;
}

bool is_inexact(const Value& value) {
    return value.exactness == Exactness::rounded || is_inexact_constant(value);
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

namespace {

Truth negated(Truth truth) { return {truth.can_fail, truth.can_hold}; }

Truth equal(const Value& a, const Value& b, bool vacant_equals_zero) {
    Truth truth;
    const bool known = a.vacancy == Vacancy::set && b.vacancy == Vacancy::set;
    if (a.symbol == b.symbol) return {true, false};
    if (!vacant_equals_zero) {
        const auto one_vacant = [](const Value& x, const Value& y) {
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

Truth less(const Value& a, const Value& b) {
    if (a.symbol == b.symbol) return {false, true};
    return {a.low < b.high, a.high >= b.low};
}

} // namespace

Truth compare(Operation operation, const Value& left, const Value& right, bool vacant_equals_zero) {
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

Truth test_vacancy(Operation operation, const Value& operand) {
    Truth vacant{operand.vacancy != Vacancy::set, operand.vacancy != Vacancy::vacant};
    return operation == Operation::is_vacant ? vacant : negated(vacant);
}

} // namespace maclint::dataflow
