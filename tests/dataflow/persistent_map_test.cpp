//! The maps and short lists that states are made of.
#include "analyzer/dataflow/domain/persistent_map.hpp"
#include "analyzer/dataflow/domain/small_vector.hpp"

#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::dataflow {
namespace {

TEST(PersistentMap, EqualContentIsEqualHoweverItCameAbout) {
    PersistentMap trees;
    const Root forwards = trees.set(trees.set(trees.set(0, 1, 10), 2, 20), 900, 30);
    const Root backwards = trees.set(trees.set(trees.set(0, 900, 30), 2, 20), 1, 10);
    ASSERT_NE(forwards, backwards);
    EXPECT_TRUE(trees.equal(forwards, backwards));
    EXPECT_FALSE(trees.equal(forwards, trees.set(backwards, 2, 21)));
    EXPECT_FALSE(trees.equal(forwards, trees.without(backwards, 2, 2)));
    EXPECT_FALSE(trees.equal(forwards, 0));
    EXPECT_FALSE(trees.equal(0, forwards));
}

TEST(PersistentMap, KeptMapsHoldWhatTheyHeld) {
    PersistentMap trees;
    Root first = trees.set(trees.set(0, 1, 10), 2, 20);
    Root second = trees.set(first, 3, 30);
    Root empty = 0;
    (void)trees.set(second, 4, 40); // asked for by nobody
    const std::vector<Root*> asked{&first, &second, &empty};
    trees.keep_only(asked);
    EXPECT_EQ(trees.find(first, 1), 10U);
    EXPECT_EQ(trees.find(first, 3), std::nullopt);
    EXPECT_EQ(trees.find(second, 2), 20U);
    EXPECT_EQ(trees.find(second, 3), 30U);
    EXPECT_EQ(trees.find(second, 4), std::nullopt);
    EXPECT_EQ(empty, 0U);
    EXPECT_EQ(trees.find(trees.set(first, 5, 50), 5), 50U);
}

TEST(PersistentMap, UnitedMapsHoldTheKeysOfBothAndTheValuesOfTheFirst) {
    std::vector<Root> maps{0};
    PersistentMap trees;
    for (const Key step : {1U, 3U, 7U, 64U})
        for (const Key first : {0U, 5U, 1000U}) {
            Root map = 0;
            for (Key i = 0; i < 20; ++i)
                map = trees.set(map, first + i * step, static_cast<std::uint32_t>(step));
            maps.push_back(map);
        }
    maps.push_back(trees.set(0, 5, 99));
    for (const Root a : maps)
        for (const Root b : maps) {
            std::vector<std::pair<Key, std::uint32_t>>
                of_a; // maps must not be made while one is gone through
            trees.for_each(a, [&](Key key, std::uint32_t value) { of_a.emplace_back(key, value); });
            Root expected = b;
            for (const auto& [key, value] : of_a) expected = trees.set(expected, key, value);
            EXPECT_TRUE(trees.equal(trees.united(a, b), expected)) << a << " and " << b;
        }
}

TEST(PersistentMap, UnitedMapsShareWhatIsTheSame) {
    PersistentMap trees;
    Root some = 0;
    for (Key key = 0; key < 20; ++key) some = trees.set(some, key, 1);
    const Root more = trees.set(some, 900, 1);
    EXPECT_EQ(trees.united(more, some), more);
    EXPECT_EQ(trees.united(some, more), more);
    EXPECT_EQ(trees.united(some, trees.set(trees.set(0, 3, 7), 4, 7)), some);
}

TEST(SmallVector, KeepsOrderAndContentBeyondItsOwnRoom) {
    SmallVector<int, 2> few{1, 3};
    few.insert(few.begin() + 1, 2);
    few.push_back(5);
    few.insert(few.end() - 1, 4);
    EXPECT_THAT(few, testing::ElementsAre(1, 2, 3, 4, 5));
    const SmallVector<int, 2> copy = few;
    few.cut_off(few.begin() + 1);
    EXPECT_THAT(few, testing::ElementsAre(1));
    EXPECT_THAT(copy, testing::ElementsAre(1, 2, 3, 4, 5));
    EXPECT_FALSE(few == copy);
}

TEST(SmallVector, IsEmptyAfterItsContentMovedAway) {
    SmallVector<int, 2> from{1, 2, 3};
    const SmallVector<int, 2> to = std::move(from);
    EXPECT_THAT(to, testing::ElementsAre(1, 2, 3));
    EXPECT_TRUE(from.empty()); // NOLINT(bugprone-use-after-move): that is what is asked
}

} // namespace
} // namespace maclint::dataflow
