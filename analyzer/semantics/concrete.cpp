//! Operators and functions, one function each.
#include "analyzer/semantics/concrete.hpp"

#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

namespace maclint::semantics {
namespace {

constexpr double degrees = 180 / std::numbers::pi;

/// Bits are those of whole numbers of 32 bits [NCT-185]; what is no such number has none.
std::optional<std::int32_t> bits_of(double number) {
    const double whole = std::round(number);
    if (!(whole >= std::numeric_limits<std::int32_t>::min() &&
          whole <= std::numeric_limits<std::int32_t>::max()))
        return std::nullopt;
    return static_cast<std::int32_t>(whole);
}

template<class F>
Result on_bits(double a, double b, const F& f) {
    const auto x = bits_of(a);
    const auto y = bits_of(b);
    if (!x || !y) return DomainError{};
    return static_cast<double>(
        static_cast<std::int32_t>(f(static_cast<std::uint32_t>(*x), static_cast<std::uint32_t>(*y))));
}

Result divide(double a, double b) {
    if (b == 0) return DomainError{}; // alarm 112
    return a / b;
}

/// T: the operands are rounded to whole numbers, the remainder has the sign of the first.
Result remainder(double a, double b) {
    const double divisor = std::round(b);
    if (divisor == 0) return DomainError{};
    return std::fmod(std::round(a), divisor);
}

Result power(double base, double exponent) {
    const double result = std::pow(base, exponent);
    if (!std::isfinite(result)) return DomainError{};
    return result;
}

/// Exactly 0 at half a turn: TAN[90] is an alarm and no large number [T].
double sine(double angle) {
    return std::fmod(angle, 180) == 0 ? 0 : std::sin(std::fmod(angle, 360) / degrees);
}

Result tangent(double angle) {
    const double cosine = sine(angle + 90);
    if (cosine == 0) return DomainError{};
    return sine(angle) / cosine;
}

/// T: from 0 to 360 degrees, as parameter 6004#0 has it unless it is changed.
double arc_tangent(double y, double x) {
    const double angle = std::atan2(y, x) * degrees;
    return angle < 0 ? angle + 360 : angle;
}

constexpr int decimal_digits = 8; // of a value in binary-coded decimals

/// Reads decimal digits of four bits each.
Result from_decimal_code(double number) {
    const double whole = std::round(number);
    if (!(whole >= 0 && whole <= std::numeric_limits<std::uint32_t>::max())) return DomainError{};
    auto code = static_cast<std::uint32_t>(whole);
    double result = 0;
    double weight = 1;
    for (int i = 0; i < decimal_digits; ++i, code >>= 4U, weight *= 10) {
        const std::uint32_t digit = code & 15U;
        if (digit > 9) return DomainError{};
        result += weight * digit;
    }
    return result;
}

Result to_decimal_code(double number) {
    const double whole = std::round(number);
    constexpr double most = 99'999'999;
    if (!(whole >= 0 && whole <= most)) return DomainError{};
    auto rest = static_cast<std::uint32_t>(whole);
    std::uint32_t code = 0;
    for (unsigned shift = 0; rest != 0; shift += 4, rest /= 10) code |= rest % 10 << shift;
    return static_cast<double>(code);
}

Result within(double low, double operand, double high, double (*f)(double)) {
    if (!(operand >= low && operand <= high)) return DomainError{};
    return f(operand);
}

/// Away from zero: FUP[1.2] is 2, FUP[-1.2] is -2.
double round_up(double number) { return number < 0 ? std::floor(number) : std::ceil(number); }

Result unary(Operation operation, double x) {
    switch (operation) {
    case Operation::negate: return -x;
    case Operation::bit_not: return on_bits(x, 0, [](std::uint32_t a, std::uint32_t) { return ~a; });
    case Operation::sine: return sine(x);
    case Operation::cosine: return sine(x + 90);
    case Operation::tangent: return tangent(x);
    case Operation::arc_sine: return within(-1, x, 1, [](double y) { return std::asin(y) * degrees; });
    case Operation::arc_cosine: return within(-1, x, 1, [](double y) { return std::acos(y) * degrees; });
    case Operation::arc_tangent: return std::atan(x) * degrees;
    case Operation::square_root: return x >= 0 ? Result(std::sqrt(x)) : Result(DomainError{});
    case Operation::absolute: return std::abs(x);
    case Operation::round: return std::round(x);
    case Operation::truncate: return std::trunc(x);
    case Operation::round_up: return round_up(x);
    case Operation::logarithm: return x > 0 ? Result(std::log(x)) : Result(DomainError{}); // [T]: 111 or 119
    case Operation::exponential: return std::exp(x);
    case Operation::to_binary: return from_decimal_code(x);
    case Operation::to_decimal_code: return to_decimal_code(x);
    default: return NotModelled{}; // ADP: how far the point is moved, the call's word decides
    }
}

Result binary(Operation operation, double a, double b) {
    switch (operation) {
    case Operation::add: return a + b;
    case Operation::subtract: return a - b;
    case Operation::multiply: return a * b;
    case Operation::divide: return divide(a, b);
    case Operation::modulo: return remainder(a, b);
    case Operation::power: return power(a, b);
    case Operation::bit_and: return on_bits(a, b, [](std::uint32_t x, std::uint32_t y) { return x & y; });
    case Operation::bit_or: return on_bits(a, b, [](std::uint32_t x, std::uint32_t y) { return x | y; });
    case Operation::bit_xor: return on_bits(a, b, [](std::uint32_t x, std::uint32_t y) { return x ^ y; });
    case Operation::arc_tangent_of_two: return arc_tangent(a, b);
    default: return NotModelled{};
    }
}

} // namespace

Result compute(Operation operation, std::span<const double> operands) {
    Result result = NotModelled{};
    if (operands.size() == 1) result = unary(operation, operands[0]);
    if (operands.size() == 2) result = binary(operation, operands[0], operands[1]);
    // There is one zero: with -0, ATAN[0]/[-#1] of a #1 that is 0 would be 180 degrees.
    if (const auto* number = std::get_if<double>(&result); number != nullptr && *number == 0) return 0.0;
    return result;
}

/// Arithmetic takes vacant for 0 [NCT-173, MITSU-326].
Result compute(Operation operation, std::span<const Content> operands) {
    constexpr std::size_t most = 2;
    std::array<double, most> numbers{};
    if (operands.size() > most) return NotModelled{};
    for (std::size_t i = 0; i < operands.size(); ++i) numbers[i] = operands[i].value_or(0);
    return compute(operation, std::span<const double>(numbers).first(operands.size()));
}

bool is_in_range(double number) {
    constexpr double largest = 1e47; // SEED-001:171-177
    return std::abs(number) <= largest;
}

double stored_in(VariableType type, double number) {
    switch (type) {
    case VariableType::integer: return std::round(number) + 0.0; // no -0
    case VariableType::truth: return number != 0 ? 1 : 0;
    case VariableType::number:
    case VariableType::text: return number;
    }
    return number;
}

/// EQ and NE tell vacant from 0 where the control does, the others take it for 0 [SEED-001:415, MITSU-326].
bool compare(Operation operation, Content left, Content right, bool vacant_equals_zero) {
    const double a = left.value_or(0);
    const double b = right.value_or(0);
    const bool equal = a == b && (vacant_equals_zero || left.has_value() == right.has_value());
    switch (operation) {
    case Operation::equal: return equal;
    case Operation::not_equal: return !equal;
    case Operation::less: return a < b;
    case Operation::less_equal: return a <= b;
    case Operation::greater: return a > b;
    case Operation::greater_equal: return a >= b;
    default: assert(false && "a comparison"); return false;
    }
}

bool test_vacancy(Operation operation, Content operand) {
    assert(is_vacancy_test(operation));
    return operand.has_value() == (operation == Operation::is_set);
}

std::optional<std::int32_t> variable_number(double index) {
    constexpr double most = 1e9;
    if (!(std::abs(index) < most)) return std::nullopt;
    return static_cast<std::int32_t>(std::lround(index));
}

} // namespace maclint::semantics
