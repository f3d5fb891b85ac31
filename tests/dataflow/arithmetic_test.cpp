//! What operations do to ranges and value numbers: worked out by hand.
#include "tests/dataflow/computing.hpp"

#include <array>

#include <gtest/gtest.h>

namespace maclint::dataflow {
namespace {

TEST_F(Arithmetic, SumsAndDifferencesTakeTheEndsThatReachFurthest) {
    EXPECT_RANGE(apply(Operation::add, range(1, 2), range(10, 20)), 11, 22);
    EXPECT_RANGE(apply(Operation::subtract, range(1, 2), range(10, 20)), -19, -8);
    EXPECT_RANGE(apply(Operation::negate, range(-1, 2)), -2, 1);
    EXPECT_RANGE(apply(Operation::add, range(1, infinity), range(-infinity, 2)), -infinity, infinity);
}

/// Each of the four corners is once the largest or the smallest.
TEST_F(Arithmetic, AProductHasFourCorners) {
    EXPECT_RANGE(apply(Operation::multiply, range(-3, 1), range(-5, 2)), -6, 15);
    EXPECT_RANGE(apply(Operation::multiply, range(-3, 1), range(-2, 5)), -15, 6);
    EXPECT_RANGE(apply(Operation::multiply, range(-1, 3), range(-5, 2)), -15, 6);
    EXPECT_RANGE(apply(Operation::multiply, range(-1, 3), range(-2, 5)), -6, 15);
    EXPECT_RANGE(apply(Operation::multiply, range(0, infinity), range(0, 2)), 0, infinity);
}

TEST_F(Arithmetic, AQuotientHasFourCornersAndNoneAcrossZero) {
    EXPECT_RANGE(apply(Operation::divide, range(-8, 4), range(2, 4)), -4, 2);
    EXPECT_RANGE(apply(Operation::divide, range(-4, 8), range(2, 4)), -2, 4);
    EXPECT_RANGE(apply(Operation::divide, range(-8, 4), range(-4, -2)), -2, 4);
    EXPECT_RANGE(apply(Operation::divide, range(1, 2), range(0, 4)), -infinity, infinity);
    EXPECT_RANGE(apply(Operation::divide, range(1, 2), range(-4, 0)), -infinity, infinity);
    EXPECT_RANGE(apply(Operation::divide, range(2, 4), range(2, infinity)), 0, 2);
}

TEST_F(Arithmetic, AnAbsoluteValueTurnsTheNegativePartOver) {
    EXPECT_RANGE(apply(Operation::absolute, range(-3, 2)), 0, 3);
    EXPECT_RANGE(apply(Operation::absolute, range(-2, 3)), 0, 3);
    EXPECT_RANGE(apply(Operation::absolute, range(-5, -2)), 2, 5);
    EXPECT_RANGE(apply(Operation::absolute, range(1, 4)), 1, 4);
}

TEST_F(Arithmetic, FunctionsThatGrowAreTakenAtBothEnds) {
    EXPECT_RANGE(apply(Operation::round, range(-1.5, 1.4)), -2, 1);
    EXPECT_RANGE(apply(Operation::truncate, range(-1.5, 1.9)), -1, 1);
    EXPECT_RANGE(apply(Operation::round_up, range(-1.1, 1.1)), -2, 2);
    EXPECT_RANGE(apply(Operation::square_root, range(4, 9)), 2, 3);
    EXPECT_RANGE(apply(Operation::square_root, range(4, infinity)), 2, infinity);
    EXPECT_RANGE(apply(Operation::square_root, range(-1, 9)), 0, infinity);
    EXPECT_RANGE(apply(Operation::sine, range(0, 1)), -1, 1);
    EXPECT_RANGE(apply(Operation::cosine, range(0, 1)), -1, 1);
    EXPECT_RANGE(apply(Operation::exponential, range(-9, 9)), 0, infinity);
}

TEST_F(Arithmetic, ARemainderOfWhatIsNotNegativeStaysBelowTheDivisor) {
    EXPECT_RANGE(apply(Operation::modulo, whole(0, 100), whole(1, 5)), 0, 5);
    EXPECT_RANGE(apply(Operation::modulo, whole(-1, 100), whole(1, 5)), -infinity, infinity);
    EXPECT_RANGE(apply(Operation::modulo, whole(0, 100), whole(0, 5)), -infinity, infinity);
}

TEST_F(Arithmetic, WhatIsPerhapsVacantIsTheReasonForAZeroThatItMakes) {
    using enum Operation;
    Value doubtful = with(Vacancy::maybe, range(1, 9));
    doubtful.vacancy_origin = 7;
    for (const Operation one : {negate, absolute, round, truncate, round_up, add_point})
        EXPECT_EQ(apply(one, doubtful).vacancy_origin, 7U);
    EXPECT_EQ(apply(multiply, range(1, 9), doubtful).vacancy_origin, 7U);
    EXPECT_EQ(apply(multiply, doubtful, range(1, 9)).vacancy_origin, 7U);
    EXPECT_EQ(apply(add, range(1, 9), doubtful).vacancy_origin, 0U);
    EXPECT_EQ(apply(cosine, doubtful).vacancy_origin, 0U);
    EXPECT_EQ(apply(negate, with(Vacancy::set, doubtful)).vacancy_origin, 0U); // no zero
    EXPECT_EQ(apply(negate, range(0, 9)).vacancy_origin, 0U);                  // no doubt
}

TEST_F(Arithmetic, WholeResultsOfConstantsAreConstants) {
    EXPECT_EQ(apply(Operation::add, number(2), number(3)).symbol, number(5).symbol);
    EXPECT_EQ(apply(Operation::truncate, number(2.7)).symbol, number(2).symbol);
    EXPECT_NE(apply(Operation::add, with(Exactness::unknown, number(2)), number(3)).symbol, number(5).symbol);
    const Value quarter = apply(Operation::divide, number(1), number(4));
    EXPECT_EQ(quarter.constant(), 0.25);
    EXPECT_FALSE(quarter.integer);
}

TEST_F(Arithmetic, WhatIsTooLargeForANumberIsNoConstant) {
    const Value large = apply(Operation::multiply, number(1e200), number(1e200));
    const Value larger = apply(Operation::multiply, number(1e300), number(1e300));
    EXPECT_NE(large.symbol, larger.symbol);
    EXPECT_RANGE(apply(Operation::subtract, larger, large), -infinity, infinity);
}

TEST_F(Arithmetic, OperandsThatCanBeExchangedGiveOneValue) {
    const Value a = whole(0, 9), b = whole(0, 9);
    EXPECT_EQ(apply(Operation::add, a, b).symbol, apply(Operation::add, b, a).symbol);
    using enum Operation;
    for (const Operation operation : {multiply, bit_and, bit_or, bit_xor})
        EXPECT_EQ(apply(operation, a, b).symbol, apply(operation, b, a).symbol);
    for (const Operation operation : {subtract, divide, modulo, power, arc_tangent_of_two})
        EXPECT_NE(apply(operation, a, b).symbol, apply(operation, b, a).symbol);
    EXPECT_NE(apply(Operation::add, a, b).symbol, apply(Operation::multiply, a, b).symbol);
}

TEST_F(Arithmetic, AFunctionThatNobodyKnowsMayGiveAnythingEachTime) {
    const Value a = whole(0, 9);
    const auto at = [&](Operation operation, std::uint32_t expression) {
        return compute(table, operation, std::array{a}, {Origin::Kind::expression, expression, 0});
    };
    EXPECT_NE(at(Operation::unknown, 1).symbol, at(Operation::unknown, 2).symbol);
    EXPECT_EQ(at(Operation::sine, 1).symbol, at(Operation::sine, 2).symbol);
    EXPECT_RANGE(at(Operation::unknown, 1), -infinity, infinity);
    EXPECT_FALSE(at(Operation::unknown, 1).integer);
    EXPECT_EQ(at(Operation::unknown, 1).exactness, Exactness::unknown);
    EXPECT_EQ(at(Operation::unknown, 1).vacancy, Vacancy::set);
}

TEST_F(Arithmetic, NotZeroStaysNotZeroUnderSigns) {
    Value value = whole(-2, 2);
    value.nonzero = true;
    EXPECT_TRUE(apply(Operation::negate, value).nonzero);
    EXPECT_TRUE(apply(Operation::absolute, value).nonzero);
    EXPECT_FALSE(apply(Operation::add, value, number(1)).nonzero);
}

} // namespace
} // namespace maclint::dataflow
