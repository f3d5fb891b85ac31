//! What ranges, vacancy and rounding tell of a comparison: worked out by hand.
#include "tests/dataflow/computing.hpp"

#include <array>

#include <gtest/gtest.h>

namespace maclint::dataflow {
namespace {

class Comparisons : public Arithmetic {};

TEST_F(Comparisons, RangesDecideComparisons) {
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

TEST_F(Comparisons, OnlyExactNumbersThatAreSurelySetAreSurelyEqual) {
    const auto three_equals = [&](const Value& other) {
        const Truth truth = compare(Operation::equal, range(3, 3), other, false);
        EXPECT_TRUE(truth.can_hold);
        const Truth exchanged = compare(Operation::equal, other, range(3, 3), false);
        EXPECT_EQ(exchanged.can_fail, truth.can_fail);
        return !truth.can_fail;
    };
    EXPECT_TRUE(three_equals(number(3)));
    EXPECT_FALSE(three_equals(with(Vacancy::unknown, range(3, 3))));
    EXPECT_FALSE(three_equals(with(Vacancy::maybe, range(3, 3))));
    EXPECT_FALSE(three_equals(with(Exactness::unknown, range(3, 3))));
    EXPECT_FALSE(three_equals(with(Exactness::rounded, range(3, 3))));
    EXPECT_FALSE(three_equals(range(3, 4)));
    EXPECT_FALSE(three_equals(range(2, 3)));
    // Whatever it is, it is equal to itself.
    const Value itself = with(Vacancy::unknown, with(Exactness::rounded, range(0, 9)));
    expect_truth(compare(Operation::equal, itself, itself, false), true, false);
    expect_truth(compare(Operation::less_equal, itself, itself, false), true, false);
    expect_truth(compare(Operation::greater, itself, itself, false), false, true);
}

TEST_F(Comparisons, VacantDiffersFromANumberUnlessTheControlTakesItForZero) {
    const Value vacant = vacant_value(table, 0);
    expect_truth(compare(Operation::equal, vacant, number(0), false), false, true);
    expect_truth(compare(Operation::not_equal, number(0), vacant, false), true, false);
    EXPECT_TRUE(compare(Operation::equal, vacant, number(0), true).can_hold);
    expect_truth(compare(Operation::equal, vacant, number(5), true), false, true);
    EXPECT_TRUE(compare(Operation::equal, vacant, with(Vacancy::unknown, range(0, 1)), false).can_hold);
    expect_truth(compare(Operation::less, vacant, number(1), false), true, false);
    expect_truth(test_vacancy(Operation::is_vacant, vacant), true, false);
    expect_truth(test_vacancy(Operation::is_set, vacant), false, true);
    expect_truth(test_vacancy(Operation::is_vacant, number(0)), false, true);
    Value maybe = range(0, 1);
    maybe.vacancy = Vacancy::maybe;
    expect_truth(test_vacancy(Operation::is_set, maybe), true, true);
    expect_truth(compare(Operation::equal, maybe, range(0, 1), false), true, true);
}

TEST_F(Comparisons, EveryComparisonHasItsOppositeAndItsMirror) {
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
    EXPECT_EQ(opposite(one_of), one_of); // it has none
    EXPECT_FALSE(is_comparison(is_vacant));
}

} // namespace
} // namespace maclint::dataflow
