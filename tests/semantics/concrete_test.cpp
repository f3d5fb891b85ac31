//! What operations do to numbers. Expected values come from the manuals' definitions, worked out by hand.
#include "analyzer/semantics/concrete.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <gtest/gtest.h>

namespace maclint::semantics {
namespace {

std::optional<double> result(Operation operation, std::initializer_list<double> operands) {
    const Result found = compute(operation, std::span(operands.begin(), operands.size()));
    const auto* number = std::get_if<double>(&found);
    return number == nullptr ? std::nullopt : std::optional(*number);
}

bool alarms(Operation operation, std::initializer_list<double> operands) {
    return std::holds_alternative<DomainError>(
        compute(operation, std::span(operands.begin(), operands.size())));
}

TEST(Concrete, AnglesAreInDegrees) {
    EXPECT_NEAR(*result(Operation::sine, {30}), 0.5, 1e-12);
    EXPECT_NEAR(*result(Operation::cosine, {60}), 0.5, 1e-12);
    EXPECT_NEAR(*result(Operation::tangent, {45}), 1, 1e-12);
    EXPECT_NEAR(*result(Operation::arc_sine, {0.5}), 30, 1e-12);
    EXPECT_NEAR(*result(Operation::arc_cosine, {0.5}), 60, 1e-12);
    EXPECT_NEAR(*result(Operation::arc_tangent, {-1}), -45, 1e-12);
}

TEST(Concrete, EveryAngleTurnsRound) {
    for (int angle = -720; angle <= 720; ++angle) {
        const double radians = angle * std::numbers::pi / 180;
        EXPECT_NEAR(*result(Operation::sine, {static_cast<double>(angle)}), std::sin(radians), 1e-12)
            << angle;
        EXPECT_NEAR(*result(Operation::cosine, {static_cast<double>(angle)}), std::cos(radians), 1e-12)
            << angle;
        if (angle % 90 == 0) continue;
        EXPECT_NEAR(*result(Operation::tangent, {static_cast<double>(angle)}), std::tan(radians), 1e-9)
            << angle;
    }
}

TEST(Concrete, QuarterTurnsAreExact) {
    EXPECT_EQ(result(Operation::sine, {180}), 0);
    EXPECT_EQ(result(Operation::sine, {-90}), -1);
    EXPECT_EQ(result(Operation::sine, {450}), 1);
    EXPECT_EQ(result(Operation::cosine, {90}), 0);
    EXPECT_EQ(result(Operation::cosine, {180}), -1);
    for (const double angle : {90.0, -270.0, 450.0}) EXPECT_EQ(result(Operation::sine, {angle}), 1);
    for (const double angle : {-90.0, 270.0, -450.0}) EXPECT_EQ(result(Operation::sine, {angle}), -1);
    for (const double angle : {0.0, -180.0, 360.0, 540.0}) EXPECT_EQ(result(Operation::sine, {angle}), 0);
    EXPECT_EQ(result(Operation::tangent, {180}), 0);
    EXPECT_TRUE(alarms(Operation::tangent, {90}));
    EXPECT_TRUE(alarms(Operation::tangent, {-270}));
}

TEST(Concrete, TheArcTangentOfTwoCoversTheWholeTurn) {
    EXPECT_NEAR(*result(Operation::arc_tangent_of_two, {1, 1}), 45, 1e-12);
    EXPECT_NEAR(*result(Operation::arc_tangent_of_two, {1, -1}), 135, 1e-12);
    EXPECT_NEAR(*result(Operation::arc_tangent_of_two, {-1, -1}), 225, 1e-12);
    EXPECT_NEAR(*result(Operation::arc_tangent_of_two, {-1, 1}), 315, 1e-12);
    EXPECT_EQ(result(Operation::arc_tangent_of_two, {0, 1}), 0);
    EXPECT_NEAR(*result(Operation::arc_tangent_of_two, {0, -1}), 180, 1e-12);
    EXPECT_NEAR(*result(Operation::arc_tangent_of_two, {-1, 0}), 270, 1e-12);
}

TEST(Concrete, ThereIsOneZero) {
    EXPECT_FALSE(std::signbit(*result(Operation::negate, {0})));
    EXPECT_FALSE(std::signbit(*result(Operation::multiply, {0, -3})));
}

TEST(Concrete, RoundGoesToTheNearestFixTowardsZeroFupAwayFromIt) {
    EXPECT_EQ(result(Operation::round, {1.5}), 2);
    EXPECT_EQ(result(Operation::round, {-1.5}), -2);
    EXPECT_EQ(result(Operation::round, {1.4}), 1);
    EXPECT_EQ(result(Operation::truncate, {1.9}), 1);
    EXPECT_EQ(result(Operation::truncate, {-1.9}), -1);
    EXPECT_EQ(result(Operation::round_up, {1.1}), 2);
    EXPECT_EQ(result(Operation::round_up, {-1.1}), -2);
    EXPECT_EQ(result(Operation::round_up, {3}), 3);
}

TEST(Concrete, ARemainderHasTheSignOfTheDividend) {
    EXPECT_EQ(result(Operation::modulo, {7, 3}), 1);
    EXPECT_EQ(result(Operation::modulo, {-7, 3}), -1);
    EXPECT_EQ(result(Operation::modulo, {7, -3}), 1);
    EXPECT_EQ(result(Operation::modulo, {7.6, 3}), 2); // of 8
    EXPECT_TRUE(alarms(Operation::modulo, {7, 0}));
    EXPECT_TRUE(alarms(Operation::modulo, {7, 0.4}));
}

TEST(Concrete, BitsAreThoseOfWholeNumbers) {
    EXPECT_EQ(result(Operation::bit_and, {12, 10}), 8);
    EXPECT_EQ(result(Operation::bit_or, {12, 10}), 14);
    EXPECT_EQ(result(Operation::bit_xor, {12, 10}), 6);
    EXPECT_EQ(result(Operation::bit_not, {0}), -1);
    EXPECT_EQ(result(Operation::bit_and, {-1, 255}), 255);
    EXPECT_EQ(result(Operation::bit_and, {12.4, 9.6}), 8); // 12 and 10
    EXPECT_EQ(result(Operation::bit_or, {2147483647, 0}), 2147483647);
    EXPECT_EQ(result(Operation::bit_or, {-2147483648, 0}), -2147483648);
    EXPECT_TRUE(alarms(Operation::bit_or, {2147483648, 1}));
    EXPECT_TRUE(alarms(Operation::bit_or, {-2147483649, 1}));
    EXPECT_TRUE(alarms(Operation::bit_and, {1, 1e12}));
    EXPECT_TRUE(alarms(Operation::bit_not, {1e12}));
}

TEST(Concrete, BinAndBcdTurnDigitsOfFourBits) {
    EXPECT_EQ(result(Operation::to_decimal_code, {25}), 0x25);
    EXPECT_EQ(result(Operation::to_binary, {0x25}), 25);
    EXPECT_EQ(result(Operation::to_decimal_code, {99999999}), 0x99999999U);
    EXPECT_EQ(result(Operation::to_binary, {0x99999999U}), 99999999);
    EXPECT_EQ(result(Operation::to_decimal_code, {0}), 0);
    EXPECT_EQ(result(Operation::to_binary, {0}), 0);
    EXPECT_EQ(result(Operation::to_decimal_code, {12345670}), 0x12345670);
    EXPECT_EQ(result(Operation::to_binary, {0x12345670}), 12345670);
    EXPECT_EQ(result(Operation::to_binary, {24.6}), 19); // 25 is 0x19
    EXPECT_EQ(result(Operation::to_decimal_code, {24.6}), 0x25);
    EXPECT_TRUE(alarms(Operation::to_binary, {0x1A}));
    EXPECT_TRUE(alarms(Operation::to_binary, {-1}));
    EXPECT_TRUE(alarms(Operation::to_binary, {4294967296}));
    EXPECT_TRUE(alarms(Operation::to_decimal_code, {-1}));
    EXPECT_TRUE(alarms(Operation::to_decimal_code, {100000000}));
}

TEST(Concrete, OutsideOfItsDomainAFunctionAlarms) {
    EXPECT_TRUE(alarms(Operation::divide, {1, 0}));
    EXPECT_TRUE(alarms(Operation::square_root, {-0.5}));
    EXPECT_TRUE(alarms(Operation::arc_sine, {1.5}));
    EXPECT_TRUE(alarms(Operation::arc_cosine, {-1.5}));
    EXPECT_TRUE(alarms(Operation::logarithm, {0}));
    EXPECT_TRUE(alarms(Operation::power, {-2, 0.5}));
    EXPECT_TRUE(alarms(Operation::arc_sine, {-1.5}));
    EXPECT_TRUE(alarms(Operation::arc_cosine, {1.5}));
    EXPECT_TRUE(alarms(Operation::logarithm, {-1}));
    EXPECT_TRUE(alarms(Operation::power, {0, -1}));
    EXPECT_EQ(result(Operation::power, {0, 0}), 1);
    EXPECT_NEAR(*result(Operation::arc_sine, {1}), 90, 1e-12);
    EXPECT_NEAR(*result(Operation::arc_sine, {-1}), -90, 1e-12);
    EXPECT_NEAR(*result(Operation::arc_cosine, {-1}), 180, 1e-12);
    EXPECT_EQ(result(Operation::arc_cosine, {1}), 0);
    EXPECT_EQ(result(Operation::square_root, {0}), 0);
    EXPECT_EQ(result(Operation::logarithm, {1}), 0);
}

TEST(Concrete, TheRestIsAsInTheBooks) {
    EXPECT_EQ(result(Operation::add, {2, 3}), 5);
    EXPECT_EQ(result(Operation::subtract, {2, 3}), -1);
    EXPECT_EQ(result(Operation::multiply, {2, 3}), 6);
    EXPECT_EQ(result(Operation::divide, {3, 2}), 1.5);
    EXPECT_EQ(result(Operation::power, {2, 3}), 8);
    EXPECT_EQ(result(Operation::negate, {2}), -2);
    EXPECT_EQ(result(Operation::absolute, {-2}), 2);
    EXPECT_EQ(result(Operation::square_root, {9}), 3);
    EXPECT_EQ(result(Operation::exponential, {0}), 1);
}

TEST(Concrete, ArithmeticTakesVacantForZero) {
    const std::array<Content, 2> operands{Content{}, Content{5}};
    EXPECT_EQ(std::get<double>(compute(Operation::add, std::span<const Content>(operands))), 5);
    EXPECT_EQ(std::get<double>(compute(Operation::negate, std::span<const Content>(operands).first(1))), 0);
    constexpr std::array<Content, 3> three{Content{1}, Content{2}, Content{3}};
    EXPECT_TRUE(
        std::holds_alternative<NotModelled>(compute(Operation::add, std::span<const Content>(three))));
}

TEST(Concrete, WhatHasNoModelIsSaidToHaveNone) {
    constexpr std::array one{1.0};
    constexpr std::array two{1.0, 2.0};
    for (const Operation operation : {Operation::add_point, Operation::unknown, Operation::less}) {
        EXPECT_TRUE(std::holds_alternative<NotModelled>(compute(operation, std::span<const double>(one))));
        EXPECT_TRUE(std::holds_alternative<NotModelled>(compute(operation, std::span<const double>(two))));
    }
}

TEST(Concrete, OnlyEqualAndNotEqualTellVacantFromZero) {
    const Content vacant{};
    EXPECT_FALSE(compare(Operation::equal, vacant, 0, false));
    EXPECT_TRUE(compare(Operation::not_equal, vacant, 0, false));
    EXPECT_TRUE(compare(Operation::equal, vacant, vacant, false));
    EXPECT_TRUE(compare(Operation::equal, vacant, 0, true));
    EXPECT_FALSE(compare(Operation::not_equal, 0, vacant, true));
    EXPECT_TRUE(compare(Operation::greater_equal, vacant, 0, false));
    EXPECT_TRUE(compare(Operation::less_equal, vacant, 0, false));
    EXPECT_FALSE(compare(Operation::greater, vacant, 0, false));
    EXPECT_FALSE(compare(Operation::less, vacant, 0, false));
    EXPECT_TRUE(compare(Operation::less, vacant, 1, false));
    EXPECT_TRUE(test_vacancy(Operation::is_vacant, vacant));
    EXPECT_FALSE(test_vacancy(Operation::is_set, vacant));
    EXPECT_TRUE(test_vacancy(Operation::is_set, 0));
    EXPECT_FALSE(test_vacancy(Operation::is_vacant, 0));
}

TEST(Concrete, AnIndexIsRounded) {
    EXPECT_EQ(variable_number(100.4), 100);
    EXPECT_EQ(variable_number(100.5), 101);
    EXPECT_EQ(variable_number(99.5), 100);
    EXPECT_EQ(variable_number(-0.4), 0);
    EXPECT_EQ(variable_number(999'999'999), 999'999'999);
    EXPECT_EQ(variable_number(1e9), std::nullopt);
    EXPECT_EQ(variable_number(1e12), std::nullopt);
    EXPECT_EQ(variable_number(-1e12), std::nullopt);
    EXPECT_EQ(variable_number(std::nan("")), std::nullopt);
}

TEST(Concrete, NumbersEndAtTenToTheFortySeven) {
    EXPECT_TRUE(is_in_range(1e47));
    EXPECT_TRUE(is_in_range(-1e47));
    EXPECT_FALSE(is_in_range(-1.1e47));
    EXPECT_FALSE(is_in_range(1.1e47));
    EXPECT_FALSE(is_in_range(std::nan("")));
}

TEST(Concrete, AnIntegerIsRoundedAndATruthIsZeroOrOne) {
    EXPECT_EQ(stored_in(VariableType::integer, 1.5), 2);
    EXPECT_EQ(stored_in(VariableType::integer, -1.5), -2);
    EXPECT_EQ(stored_in(VariableType::truth, -3), 1);
    EXPECT_EQ(stored_in(VariableType::truth, 0), 0);
    EXPECT_EQ(stored_in(VariableType::number, 1.5), 1.5);
}

} // namespace
} // namespace maclint::semantics
