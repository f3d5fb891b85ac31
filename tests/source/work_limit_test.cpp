//! What a limit counts, and what it does not.
#include "analyzer/source/made_once.hpp"
#include "analyzer/source/work_limit.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace maclint {
namespace {

TEST(WorkLimit, IsMetByTheFirstThatIsTooMuch) {
    EXPECT_TRUE(WorkLimit::allows(1'000'000)) << "without a limit";
    const WorkLimit limit(3);
    EXPECT_TRUE(WorkLimit::allows());
    EXPECT_TRUE(WorkLimit::allows(2));
    EXPECT_FALSE(limit.is_met());
    EXPECT_FALSE(WorkLimit::allows());
    EXPECT_TRUE(limit.is_met());
    EXPECT_TRUE(WorkLimit::is_innermost_met());
}

TEST(WorkLimit, StaysMetForLess) {
    const WorkLimit limit(3);
    EXPECT_FALSE(WorkLimit::allows(4));
    EXPECT_FALSE(WorkLimit::allows(0));
    EXPECT_TRUE(limit.is_met());
}

TEST(WorkLimit, OfAnotherQuestionWithinIsItsOwn) {
    const WorkLimit outer(1);
    {
        const WorkLimit inner(0);
        EXPECT_FALSE(WorkLimit::allows());
    }
    EXPECT_FALSE(WorkLimit::is_innermost_met());
    EXPECT_TRUE(WorkLimit::allows());
}

TEST(WorkLimit, DoesNotCountInAPauseNorWhatIsMadeForAll) {
    const WorkLimit limit(1);
    {
        const WorkLimit::Pause pause;
        EXPECT_TRUE(WorkLimit::allows(100));
    }
    MadeOnce<int> thing;
    EXPECT_EQ(thing.get([] { return WorkLimit::allows(100) ? 7 : 0; }), 7);
    EXPECT_FALSE(limit.is_met());
    EXPECT_TRUE(WorkLimit::allows());
    EXPECT_FALSE(WorkLimit::allows());
}

TEST(WorkLimit, EndsALookAtManyThings) {
    const std::vector<int> things{1, 2, 3};
    const auto is = [](int wanted) { return [wanted](int thing) { return thing == wanted; }; };
    EXPECT_TRUE(any_within_limit(things, is(3)));
    EXPECT_FALSE(any_within_limit(things, is(4)));
    const WorkLimit limit(2);
    EXPECT_FALSE(any_within_limit(things, is(3)));
    EXPECT_TRUE(limit.is_met());
}

} // namespace
} // namespace maclint
