//! A table of what each operation does to whole and exact numbers.
#include "analyzer/semantics/exactness.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace maclint::semantics {
namespace {

/// What an operation does to whole numbers and to rounding.
struct Row {
    Operation operation;
    enum class Whole : std::uint8_t { never, if_operands, if_exponent_too, always } whole;
    enum class Rounds : std::uint8_t {
        never,
        unless_whole,
        unless_whole_power,
        always,
        by_divisor,
        havocs,
        unknown
    } rounds;
};

using W = Row::Whole;
using R = Row::Rounds;

// Sources: macro reference, section 3 (functions and logic on whole numbers), SEED-001:306-332 (rounding).
constexpr auto rows = std::to_array<Row>({
    {Operation::add, W::if_operands, R::unless_whole},
    {Operation::subtract, W::if_operands, R::unless_whole},
    {Operation::multiply, W::if_operands, R::unless_whole},
    {Operation::divide, W::never, R::by_divisor},
    {Operation::modulo, W::if_operands, R::unless_whole},
    {Operation::power, W::if_exponent_too, R::unless_whole_power},
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

/// The row of each operation; of those that have none nothing is known.
constexpr auto row_of = [] {
    std::array<Row, static_cast<std::size_t>(Operation::unknown) + 1> all{};
    all.fill({Operation::unknown, W::never, R::unknown});
    for (const Row& row : rows) all[static_cast<std::size_t>(row.operation)] = row;
    return all;
}();

const Row& find_row(Operation operation) { return row_of[static_cast<std::size_t>(operation)]; }

/// A fraction with few binary digits: sums of such numbers are exact.
bool is_dyadic(double number) {
    constexpr double grid = 1024;
    return std::abs(number) < 1e9 && std::floor(number * grid) == number * grid;
}

bool is_power_of_two(double number) {
    int exponent = 0;
    return number != 0 && std::isfinite(number) && std::abs(std::frexp(number, &exponent)) == 0.5;
}

/// A number written with decimals that binary arithmetic cannot hold: 0.1.
bool is_inexact_constant(const AbstractValue& value) {
    return value.low == value.high && !value.integer && !is_dyadic(value.low);
}

Exactness of_quotient(const AbstractValue& dividend, const AbstractValue& divisor) {
    if (const auto by = divisor.constant(); by && *by != 0) {
        if (is_power_of_two(*by)) return dividend.exactness;
        if (const auto number = dividend.constant(); number && is_dyadic(*number / *by))
            return std::max(dividend.exactness, divisor.exactness);
    }
    return Exactness::rounded;
}

Exactness of_sum_or_product(const AbstractValue& a, const AbstractValue& b) {
    const Exactness operands = std::max(a.exactness, b.exactness);
    if (is_inexact_constant(a) || is_inexact_constant(b)) return Exactness::rounded;
    const auto is_on_grid = [](const AbstractValue& value) {
        return value.integer || (value.low == value.high && is_dyadic(value.low));
    };
    return is_on_grid(a) && is_on_grid(b) ? operands : std::max(operands, Exactness::unknown);
}

} // namespace

bool gives_whole_numbers(Operation operation, const AbstractValue& first, const AbstractValue& second) {
    const bool operands = first.integer && second.integer;
    switch (find_row(operation).whole) {
    case W::never: return false;
    case W::if_operands: return operands;
    case W::if_exponent_too: return operands && second.low >= 0; // POW[2,-1] is 0.5
    case W::always: return true;
    }
    return false;
}

Exactness exactness_of(Operation operation, const AbstractValue& first, const AbstractValue& second) {
    switch (find_row(operation).rounds) {
    case R::never: return std::max(first.exactness, second.exactness);
    case R::unless_whole: return of_sum_or_product(first, second);
    case R::unless_whole_power: // 3 to the power of -1 is rounded, 2 to the power of 0.5, too
        return std::max(of_sum_or_product(first, second), gives_whole_numbers(operation, first, second)
                                                              ? Exactness::exact
                                                              : Exactness::unknown);
    case R::always: return Exactness::rounded;
    case R::by_divisor: return of_quotient(first, second);
    case R::havocs: return Exactness::exact;
    case R::unknown: return Exactness::unknown;
    }
    return Exactness::unknown;
}

bool always_rounds(Operation operation) { return find_row(operation).rounds == R::always; }

bool is_inexact(const AbstractValue& value) {
    return value.exactness == Exactness::rounded || is_inexact_constant(value);
}

} // namespace maclint::semantics
