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

TEST(PersistentMap, KeysBetweenTwoAreTakenOutWhereverTheyStand) {
    PersistentMap trees;
    Root map = 0;
    for (const Key key : {0U, 5U, 6U, 7U, 8U, 9U, 900U})
        map = trees.set(map, key, static_cast<std::uint32_t>(key));
    const Root rest = trees.without(map, 6, 8);
    for (const Key key : {0U, 5U, 9U, 900U}) EXPECT_EQ(trees.find(rest, key), key);
    for (const Key key : {6U, 7U, 8U}) EXPECT_EQ(trees.find(rest, key), std::nullopt);
    EXPECT_EQ(trees.without(rest, 6, 8), rest);
    EXPECT_EQ(trees.without(rest, 0, 900), 0U);
}

TEST(PersistentMap, ManyKeysSetAtATimeAreThoseThatHaveAValue) {
    PersistentMap trees;
    const Root before = trees.set(trees.set(0, 4, 1), 17, 2);
    constexpr auto none = PersistentMap::absent;
    const std::vector<std::uint32_t> values{none, 50,   none, 70,   80,   none, none,
                                            none, none, none, none, none, none, 17};
    const Root after = trees.set_all(before, 4, values);
    Root expected = before;
    for (Key key = 0; key < values.size(); ++key)
        if (values[key] != none) expected = trees.set(expected, 4 + key, values[key]);
    EXPECT_TRUE(trees.equal(after, expected));
    EXPECT_EQ(trees.find(after, 4), 1U);
    EXPECT_EQ(trees.find(after, 17), 17U);
    EXPECT_EQ(trees.set_all(after, 4, values), after);
    EXPECT_EQ(trees.set_all(0, 4, std::vector<std::uint32_t>(20, none)), 0U);
}

TEST(PersistentMap, MergedMapsAskForWhatDiffers) {
    PersistentMap trees;
    const Root both = trees.set(trees.set(0, 1, 1), 3, 3);
    const Root a = trees.set(trees.set(both, 2, 20), 40, 4);
    const Root b = trees.set(trees.set(both, 2, 21), 5, 5);
    const Root merged = trees.merge(
        a, b, [](Key, std::uint32_t x, std::uint32_t y) { return x + y; },
        [](Key, std::uint32_t x) { return 100 + x; }, [](Key, std::uint32_t y) { return 200 + y; });
    std::vector<std::pair<Key, std::uint32_t>> content;
    trees.for_each(merged, [&](Key key, std::uint32_t value) { content.emplace_back(key, value); });
    EXPECT_THAT(content, testing::ElementsAre(std::pair(1, 1), std::pair(2, 41), std::pair(3, 3),
                                              std::pair(5, 205), std::pair(40, 104)));
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

TEST(SmallVector, OfOneThingManyTimes) {
    SmallVector<int, 2> many(3, 7);
    many[1] = 8;
    EXPECT_THAT(many, testing::ElementsAre(7, 8, 7));
    SmallVector<int, 2> other{1};
    other = many;
    EXPECT_EQ(other, many);
    other = SmallVector<int, 2>(1, 5);
    EXPECT_THAT(other, testing::ElementsAre(5));
}

TEST(SmallVector, IsEmptyAfterItsContentMovedAway) {
    SmallVector<int, 2> from{1, 2, 3};
    const SmallVector<int, 2> to = std::move(from);
    EXPECT_THAT(to, testing::ElementsAre(1, 2, 3));
    EXPECT_TRUE(from.empty()); // NOLINT(bugprone-use-after-move): that is what is asked
}

} // namespace
} // namespace maclint::dataflow
