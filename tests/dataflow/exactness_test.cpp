//! What operations do to whole numbers and to rounding: worked out by hand.
#include "tests/dataflow/computing.hpp"

#include <array>

#include <gtest/gtest.h>

namespace maclint::dataflow {
namespace {

class ExactResults : public Arithmetic {};

TEST_F(ExactResults, WholeNumbersStayWholeUnlessTheyAreDivided) {
    EXPECT_TRUE(apply(Operation::add, whole(0, 2), whole(0, 2)).integer);
    EXPECT_FALSE(apply(Operation::add, whole(0, 2), range(0, 2)).integer);
    EXPECT_TRUE(apply(Operation::multiply, whole(0, 2), whole(0, 2)).integer);
    EXPECT_FALSE(apply(Operation::divide, whole(0, 2), whole(1, 2)).integer);
    EXPECT_TRUE(apply(Operation::truncate, range(0, 2)).integer);
    EXPECT_TRUE(apply(Operation::round_up, range(0, 2)).integer);
    EXPECT_TRUE(apply(Operation::bit_and, range(0, 2), range(0, 2)).integer);
    EXPECT_FALSE(apply(Operation::sine, whole(0, 2)).integer);
    EXPECT_FALSE(apply(Operation::add_point, whole(0, 2)).integer);
    for (const Operation operation : {Operation::subtract, Operation::modulo, Operation::power}) {
        EXPECT_TRUE(apply(operation, whole(0, 2), whole(1, 2)).integer);
        EXPECT_FALSE(apply(operation, range(0, 2), whole(1, 2)).integer);
        EXPECT_FALSE(apply(operation, whole(0, 2), range(1, 2)).integer);
    }
    for (const Operation operation : {Operation::negate, Operation::absolute}) {
        EXPECT_TRUE(apply(operation, whole(0, 2)).integer);
        EXPECT_FALSE(apply(operation, range(0, 2)).integer);
    }
}

TEST_F(ExactResults, APowerIsWholeOnlyWhereTheExponentIsNotNegative) {
    EXPECT_TRUE(apply(Operation::power, whole(2, 3), whole(0, 2)).integer);
    EXPECT_FALSE(apply(Operation::power, whole(2, 3), whole(-1, 2)).integer);
}

TEST_F(ExactResults, RoundingTouchesWhatBinaryNumbersCannotHold) {
    EXPECT_EQ(apply(Operation::add, range(0, 9), number(0.5)).exactness, Exactness::unknown);
    EXPECT_EQ(apply(Operation::add, whole(0, 9), number(0.5)).exactness, Exactness::exact);
    EXPECT_EQ(apply(Operation::add, whole(0, 9), number(0.1)).exactness, Exactness::rounded);
    EXPECT_EQ(apply(Operation::divide, whole(0, 9), number(2)).exactness, Exactness::exact);
    EXPECT_EQ(apply(Operation::divide, whole(0, 9), number(3)).exactness, Exactness::rounded);
    EXPECT_EQ(apply(Operation::divide, number(9), number(3)).exactness, Exactness::exact);
    EXPECT_EQ(apply(Operation::sine, whole(0, 9)).exactness, Exactness::rounded);
    EXPECT_EQ(apply(Operation::truncate, apply(Operation::sine, whole(0, 9))).exactness, Exactness::exact);
    EXPECT_TRUE(is_inexact(number(0.1)));
    EXPECT_FALSE(is_inexact(number(0.25)));
}

TEST_F(ExactResults, OfLargeWholeNumbersAreExactToo) {
    for (const double large : {1e9, 2e9, 123456789012.0}) {
        EXPECT_FALSE(is_inexact(number(large))) << large;
        EXPECT_EQ(apply(Operation::add, number(large), whole(0, 9)).exactness, Exactness::exact) << large;
        EXPECT_EQ(apply(Operation::multiply, whole(0, 9), number(large)).exactness, Exactness::exact)
            << large;
    }
    EXPECT_TRUE(is_inexact(number(1e9 + 0.1)));
}

TEST_F(ExactResults, LogicAndRoundingGiveExactWholeNumbersOfWhateverTheyTake) {
    using enum Operation;
    const Value inexact = with(Exactness::rounded, range(0, 9));
    const auto expect_exact = [](const Value& value) {
        EXPECT_TRUE(value.integer);
        EXPECT_EQ(value.exactness, Exactness::exact);
    };
    for (const Operation one : {bit_not, round, truncate, round_up, to_binary, to_decimal_code})
        expect_exact(apply(one, inexact));
    for (const Operation two : {bit_and, bit_or, bit_xor}) expect_exact(apply(two, inexact, inexact));
}

TEST_F(ExactResults, AnglesRootsAndLogarithmsAreRoundedWhereTheyAreTaken) {
    using enum Operation;
    const auto expect_rounded_here = [&](const Value& value) {
        EXPECT_FALSE(value.integer);
        EXPECT_EQ(value.exactness, Exactness::rounded);
        EXPECT_EQ(table.origins[value.rounding], here);
    };
    for (const Operation one :
         {sine, cosine, tangent, arc_sine, arc_cosine, arc_tangent, square_root, logarithm, exponential}) {
        expect_rounded_here(apply(one, whole(0, 9)));
        expect_rounded_here(apply(one, rounded_before()));
    }
    expect_rounded_here(apply(arc_tangent_of_two, whole(0, 9), whole(1, 9)));
}

TEST_F(ExactResults, WhatWasRoundedStaysSoAndKeepsThePlace) {
    using enum Operation;
    const Value rounded = rounded_before();
    const auto expect_as_before = [&](const Value& value) {
        EXPECT_EQ(value.exactness, Exactness::rounded);
        EXPECT_EQ(value.rounding, rounded.rounding);
    };
    for (const Operation one : {negate, absolute, add_point}) expect_as_before(apply(one, rounded));
    for (const Operation two : {add, subtract, multiply, modulo, power}) {
        expect_as_before(apply(two, rounded, whole(1, 9)));
        expect_as_before(apply(two, whole(1, 9), rounded));
    }
    expect_as_before(apply(divide, rounded, number(2)));
    EXPECT_EQ(table.origins[apply(add, whole(0, 9), number(0.1)).rounding], here);
    EXPECT_EQ(table.origins[apply(divide, whole(0, 9), number(3)).rounding], here);
    EXPECT_EQ(apply(add, whole(0, 9), whole(0, 9)).rounding, 0U);
}

TEST_F(ExactResults, AQuotientIsExactByPowersOfTwoAndWhereItComesOut) {
    const Value unknown = with(Exactness::unknown, range(0, 9));
    const auto exactness = [&](const Value& a, const Value& b) {
        return apply(Operation::divide, a, b).exactness;
    };
    EXPECT_EQ(exactness(whole(0, 9), number(-4)), Exactness::exact);
    EXPECT_EQ(exactness(whole(0, 9), number(0.5)), Exactness::exact);
    EXPECT_EQ(exactness(unknown, number(4)), Exactness::unknown);
    EXPECT_EQ(exactness(unknown, number(3)), Exactness::rounded);
    EXPECT_EQ(exactness(whole(0, 9), number(0)), Exactness::rounded);
    EXPECT_EQ(exactness(whole(0, 9), whole(1, 2)), Exactness::rounded);
    EXPECT_EQ(exactness(number(3), number(12)), Exactness::exact);
    EXPECT_EQ(exactness(number(1), number(3)), Exactness::rounded);
    // Nine, perhaps rounded, by three is three, perhaps rounded.
    EXPECT_EQ(exactness(with(Exactness::unknown, number(9)), number(3)), Exactness::unknown);
}

} // namespace
} // namespace maclint::dataflow
