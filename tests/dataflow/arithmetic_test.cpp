//! What operations do to ranges, whole numbers and rounding: bounds worked out by hand.
#include "analyzer/dataflow/arithmetic.hpp"

#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace maclint::dataflow {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

class Arithmetic : public testing::Test {
  protected:
    ValueTable table;

    Value range(double low, double high) {
        Value value;
        value.symbol = table.symbols({Symbol::Kind::opaque, ++values_, 0, 0});
        value.low = low;
        value.high = high;
        value.vacancy = Vacancy::set;
        value.exactness = Exactness::exact;
        return value;
    }
    Value whole(double low, double high) {
        Value value = range(low, high);
        value.integer = true;
        return value;
    }
    Value number(double value) { return number_value(table, value); }

    Value apply(Operation operation, const Value& a) {
        return compute(table, operation, std::array{a}, {Origin::Kind::expression, 1, 0});
    }
    Value apply(Operation operation, const Value& a, const Value& b) {
        return compute(table, operation, std::array{a, b}, {Origin::Kind::expression, 1, 0});
    }

  private:
    std::uint64_t values_ = 0;
};

#define EXPECT_RANGE(value, from, to)                                                                        \
    {                                                                                                        \
        const Value found = value;                                                                           \
        EXPECT_EQ(found.low, from);                                                                          \
        EXPECT_EQ(found.high, to);                                                                           \
    }

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

TEST_F(Arithmetic, WholeNumbersStayWholeUnlessTheyAreDivided) {
    EXPECT_TRUE(apply(Operation::add, whole(0, 2), whole(0, 2)).integer);
    EXPECT_FALSE(apply(Operation::add, whole(0, 2), range(0, 2)).integer);
    EXPECT_TRUE(apply(Operation::multiply, whole(0, 2), whole(0, 2)).integer);
    EXPECT_FALSE(apply(Operation::divide, whole(0, 2), whole(1, 2)).integer);
    EXPECT_TRUE(apply(Operation::truncate, range(0, 2)).integer);
    EXPECT_TRUE(apply(Operation::round_up, range(0, 2)).integer);
    EXPECT_TRUE(apply(Operation::bit_and, range(0, 2), range(0, 2)).integer);
    EXPECT_FALSE(apply(Operation::sine, whole(0, 2)).integer);
    EXPECT_FALSE(apply(Operation::add_point, whole(0, 2)).integer);
}

TEST_F(Arithmetic, APowerIsWholeOnlyWhereTheExponentIsNotNegative) {
    EXPECT_TRUE(apply(Operation::power, whole(2, 3), whole(0, 2)).integer);
    EXPECT_FALSE(apply(Operation::power, whole(2, 3), whole(-1, 2)).integer);
}

TEST_F(Arithmetic, RoundingTouchesWhatBinaryNumbersCannotHold) {
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

TEST_F(Arithmetic, WholeResultsOfConstantsAreConstants) {
    EXPECT_EQ(apply(Operation::add, number(2), number(3)).symbol, number(5).symbol);
    EXPECT_EQ(apply(Operation::truncate, number(2.7)).symbol, number(2).symbol);
}

TEST_F(Arithmetic, OperandsThatCanBeExchangedGiveOneValue) {
    const Value a = whole(0, 9), b = whole(0, 9);
    EXPECT_EQ(apply(Operation::add, a, b).symbol, apply(Operation::add, b, a).symbol);
    EXPECT_EQ(apply(Operation::bit_xor, a, b).symbol, apply(Operation::bit_xor, b, a).symbol);
    EXPECT_NE(apply(Operation::subtract, a, b).symbol, apply(Operation::subtract, b, a).symbol);
    EXPECT_NE(apply(Operation::add, a, b).symbol, apply(Operation::multiply, a, b).symbol);
}

TEST_F(Arithmetic, NotZeroStaysNotZeroUnderSigns) {
    Value value = whole(-2, 2);
    value.nonzero = true;
    EXPECT_TRUE(apply(Operation::negate, value).nonzero);
    EXPECT_TRUE(apply(Operation::absolute, value).nonzero);
    EXPECT_FALSE(apply(Operation::add, value, number(1)).nonzero);
}

void expect_truth(Truth truth, bool can_hold, bool can_fail) {
    EXPECT_EQ(truth.can_hold, can_hold);
    EXPECT_EQ(truth.can_fail, can_fail);
}

TEST_F(Arithmetic, RangesDecideComparisons) {
    const auto decide = [&](Operation operation, const Value& a, const Value& b) {
        return compare(operation, a, b, false);
    };
    expect_truth(decide(Operation::less, range(1, 2), range(3, 4)), true, false);
    expect_truth(decide(Operation::less, range(1, 3), range(3, 4)), true, true);
    expect_truth(decide(Operation::less, range(3, 4), range(1, 3)), false, true);
    expect_truth(decide(Operation::less_equal, range(1, 3), range(3, 4)), true, false);
    expect_truth(decide(Operation::less_equal, range(4, 5), range(1, 3)), false, true);
    expect_truth(decide(Operation::greater, range(3, 4), range(1, 2)), true, false);
    expect_truth(decide(Operation::greater, range(1, 3), range(3, 4)), false, true);
    expect_truth(decide(Operation::greater_equal, range(3, 4), range(1, 3)), true, false);
    expect_truth(decide(Operation::equal, range(1, 2), range(3, 4)), false, true);
    expect_truth(decide(Operation::equal, range(1, 3), range(3, 4)), true, true);
    expect_truth(decide(Operation::equal, number(3), number(3)), true, false);
    expect_truth(decide(Operation::not_equal, range(1, 2), range(3, 4)), true, false);
    expect_truth(decide(Operation::not_equal, number(3), number(3)), false, true);
    const Value same = range(0, 9);
    expect_truth(decide(Operation::equal, same, same), true, false);
    expect_truth(decide(Operation::less, same, same), false, true);
}

TEST_F(Arithmetic, VacantDiffersFromANumberUnlessTheControlTakesItForZero) {
    const Value vacant = vacant_value(table, 0);
    expect_truth(compare(Operation::equal, vacant, number(0), false), false, true);
    expect_truth(compare(Operation::not_equal, number(0), vacant, false), true, false);
    EXPECT_TRUE(compare(Operation::equal, vacant, number(0), true).can_hold);
    expect_truth(test_vacancy(Operation::is_vacant, vacant), true, false);
    expect_truth(test_vacancy(Operation::is_set, vacant), false, true);
    expect_truth(test_vacancy(Operation::is_vacant, number(0)), false, true);
    Value maybe = range(0, 1);
    maybe.vacancy = Vacancy::maybe;
    expect_truth(test_vacancy(Operation::is_set, maybe), true, true);
    expect_truth(compare(Operation::equal, maybe, range(0, 1), false), true, true);
}

TEST_F(Arithmetic, EveryComparisonHasItsOppositeAndItsMirror) {
    using enum Operation;
    constexpr std::array<std::array<Operation, 3>, 6> rows{{{equal, not_equal, equal},
                                                            {not_equal, equal, not_equal},
                                                            {less, greater_equal, greater},
                                                            {less_equal, greater, greater_equal},
                                                            {greater, less_equal, less},
                                                            {greater_equal, less, less_equal}}};
    for (const auto& [operation, opposed, exchanged] : rows) {
        EXPECT_EQ(opposite(operation), opposed);
        EXPECT_EQ(mirrored(operation), exchanged);
        EXPECT_TRUE(is_comparison(operation));
    }
    EXPECT_EQ(opposite(is_vacant), is_set);
    EXPECT_EQ(opposite(is_set), is_vacant);
    EXPECT_FALSE(is_comparison(is_vacant));
}

} // namespace
} // namespace maclint::dataflow
