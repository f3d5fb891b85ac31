//! What plain blocks in a row leave behind.
#include "analyzer/program/plain_run.hpp"

#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using ::testing::ElementsAre;

TEST(GroupSet, HoldsAsManyGroupsAsAControlHas) {
    syntax::GroupSet groups;
    for (const std::uint8_t group : std::array<std::uint8_t, 4>{3, 63, 64, 127})
        EXPECT_FALSE(groups.add(group));
    EXPECT_TRUE(groups.add(64));
    EXPECT_EQ(groups.size(), 4U);
    std::vector<int> in_order;
    groups.for_each([&](std::uint8_t group) { in_order.push_back(group); });
    EXPECT_THAT(in_order, ElementsAre(3, 63, 64, 127));
}

TEST(PlainRunTotals, LeaveTheLastSettingOfEachGroupInTheOrderOfTheText) {
    syntax::PlainBlock block{};
    block.settings_count = 3;
    block.settings_memory[0] = {70, 1};
    block.settings_memory[1] = {5, 2};
    block.settings_memory[2] = {70, 3};
    PlainRunTotals totals;
    totals.add(block);
    const auto net = totals.net();
    ASSERT_EQ(net.size(), 2U);
    EXPECT_EQ(net[0].group, 5);
    EXPECT_EQ(net[1].group, 70);
    EXPECT_EQ(net[1].value, 3);
}

} // namespace
} // namespace maclint
