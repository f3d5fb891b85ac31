//! What a budget counts, and what it does not.
#include "analyzer/source/budget.hpp"
#include "analyzer/source/made_once.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace maclint {
namespace {

TEST(Budget, IsSpentByTheFirstThatIsTooMuch) {
    EXPECT_TRUE(Budget::allows(1'000'000)) << "without a budget";
    const Budget budget(3);
    EXPECT_TRUE(Budget::allows());
    EXPECT_TRUE(Budget::allows(2));
    EXPECT_FALSE(budget.is_spent());
    EXPECT_FALSE(Budget::allows());
    EXPECT_TRUE(budget.is_spent());
    EXPECT_TRUE(Budget::is_innermost_spent());
}

TEST(Budget, StaysSpentForLess) {
    const Budget budget(3);
    EXPECT_FALSE(Budget::allows(4));
    EXPECT_FALSE(Budget::allows(0));
    EXPECT_TRUE(budget.is_spent());
}

TEST(Budget, OfAnotherQuestionWithinIsItsOwn) {
    const Budget outer(1);
    {
        const Budget inner(0);
        EXPECT_FALSE(Budget::allows());
    }
    EXPECT_FALSE(Budget::is_innermost_spent());
    EXPECT_TRUE(Budget::allows());
}

TEST(Budget, LearnsOfSearchesThatGiveUpWithinIt) {
    const Budget other(9);
    {
        const Budget outer(9);
        {
            const Budget inner = Budget::without_bound();
            EXPECT_FALSE(inner.gave_up());
            Budget::note_given_up();
            EXPECT_TRUE(inner.gave_up());
        }
        EXPECT_TRUE(outer.gave_up());
        EXPECT_FALSE(outer.is_spent());
        EXPECT_FALSE(other.gave_up()) << "not yet: it is told at the end";
    }
    EXPECT_TRUE(other.gave_up());
}

TEST(Budget, CountsNothingWithoutBoundNorWhatIsMadeForAll) {
    const Budget budget(1);
    {
        const Budget own = Budget::without_bound();
        EXPECT_TRUE(Budget::allows(100));
    }
    MadeOnce<int> thing;
    EXPECT_EQ(thing.get([] { return Budget::allows(100) ? 7 : 0; }), 7);
    EXPECT_FALSE(budget.is_spent());
    EXPECT_TRUE(Budget::allows());
    EXPECT_FALSE(Budget::allows());
}

TEST(Budget, EndsALookAtManyThings) {
    const std::vector<int> things{1, 2, 3};
    const auto is = [](int wanted) { return [wanted](int thing) { return thing == wanted; }; };
    EXPECT_TRUE(any_within_budget(things, is(3)));
    EXPECT_FALSE(any_within_budget(things, is(4)));
    const Budget budget(2);
    EXPECT_FALSE(any_within_budget(things, is(3)));
    EXPECT_TRUE(budget.is_spent());
}

} // namespace
} // namespace maclint
