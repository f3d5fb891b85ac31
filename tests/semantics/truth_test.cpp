//! What comparisons are said to turn out to be, held against how they turn out: random values, random
//! contents of them, and the truths that concrete.hpp makes of those.
#include "analyzer/semantics/truth.hpp"
#include "tests/semantics/sampling.hpp"

#include <functional>
#include <optional>

#include <gtest/gtest.h>

namespace maclint::semantics {
namespace {

/// A comparison of contents that the two values allow.
struct Compared {
    Operation operation;
    AbstractValue left, right;
    Content a, b;
    bool vacant_equals_zero;
    bool holds;
};

std::ostream& operator<<(std::ostream& out, const Compared& what) {
    return out << "operation " << static_cast<int>(what.operation) << " of " << spell(what.a) << " ("
               << what.left << ") and " << spell(what.b) << " (" << what.right
               << (what.vacant_equals_zero ? "), vacant equals 0" : ")");
}

void for_many_comparisons(const std::function<void(const Compared&)>& visit) {
    Sampler sampler;
    constexpr int rounds = 10000;
    for (int round = 0; round < rounds; ++round) {
        for (const Operation operation : comparisons) {
            Compared what{operation, sampler.value(), sampler.value(), {}, {}, sampler.dice().one_in(2),
                          false};
            what.a = sampler.content(what.left);
            what.b =
                sampler.dice().one_in(3) && allows(what.right, what.a) ? what.a : sampler.content(what.right);
            what.holds = compare(operation, what.a, what.b, what.vacant_equals_zero);
            visit(what);
        }
    }
}

TEST(AbstractTruth, ComparisonsTurnOutAsTheyCan) {
    int decided = 0;
    for_many_comparisons([&](const Compared& what) {
        const Truth truth = compare(what.operation, what.left, what.right, what.vacant_equals_zero);
        EXPECT_TRUE(what.holds ? truth.can_hold : truth.can_fail) << what;
        if (truth.can_hold != truth.can_fail) ++decided;
    });
    EXPECT_GT(decided, 10000);
}

TEST(AbstractTruth, AValueComparedWithItselfTurnsOutAlike) {
    Sampler sampler;
    for (int round = 0; round < 1000; ++round) {
        const Content content = sampler.content(sampler.value());
        for (const Operation operation : comparisons) {
            const Truth truth = compare_with_itself(operation);
            EXPECT_NE(truth.can_hold, truth.can_fail);
            EXPECT_EQ(truth.can_hold, compare(operation, content, content, false)) << spell(content);
        }
    }
}

TEST(AbstractTruth, VacancyTestsTurnOutAsTheyCan) {
    Sampler sampler;
    int decided = 0;
    for (int round = 0; round < 10000; ++round) {
        const AbstractValue value = sampler.value();
        const Content content = sampler.content(value);
        for (const Operation operation : {Operation::is_vacant, Operation::is_set}) {
            const Truth truth = test_vacancy(operation, value);
            EXPECT_TRUE(test_vacancy(operation, content) ? truth.can_hold : truth.can_fail)
                << spell(content) << ": " << value;
            if (truth.can_hold != truth.can_fail) ++decided;
        }
    }
    EXPECT_GT(decided, 1000);
}

TEST(AbstractTruth, WhatIsLeftWhereAComparisonIsTrueAllowsAllThatPasses) {
    int impossible = 0, smaller = 0;
    for_many_comparisons([&](const Compared& what) {
        const auto left = refine(what.left, what.operation, what.right, what.vacant_equals_zero);
        if (!left) {
            ++impossible;
            EXPECT_FALSE(what.holds) << what;
        } else if (what.holds) {
            EXPECT_TRUE(allows(*left, what.a)) << what << ", left is " << *left;
        }
        if (left && !(*left == what.left)) ++smaller;
    });
    EXPECT_GT(impossible, 1000);
    EXPECT_GT(smaller, 1000);
}

TEST(AbstractTruth, TheOppositeFailsAndTheMirroredHoldsWithTheSidesExchanged) {
    for_many_comparisons([](const Compared& what) {
        EXPECT_NE(compare(opposite(what.operation), what.a, what.b, what.vacant_equals_zero), what.holds)
            << what;
        EXPECT_EQ(compare(mirrored(what.operation), what.b, what.a, what.vacant_equals_zero), what.holds)
            << what;
    });
    EXPECT_EQ(opposite(Operation::is_vacant), Operation::is_set);
    EXPECT_EQ(opposite(Operation::is_set), Operation::is_vacant);
}

} // namespace
} // namespace maclint::semantics
