//! What points to each other is one component, and comes before whatever points to it.
#include "analyzer/flow/components.hpp"
#include "tests/support/dice.hpp"

#include <algorithm>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::flow {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Lists = std::vector<std::vector<std::uint32_t>>;

Adjacency pointing(const Lists& lists) {
    Adjacency adjacency;
    for (const auto& list : lists) {
        for (const std::uint32_t to : list) adjacency.add(to);
        adjacency.end_list();
    }
    return adjacency;
}

Lists members_of(const Components& components) {
    Lists all;
    for (std::size_t i = 0; i < components.members.size(); ++i)
        all.emplace_back(components.members[i].begin(), components.members[i].end());
    return all;
}

TEST(SliceTable, HoldsItsListsApart) {
    const Adjacency lists = pointing({{5, 3}, {}, {7}, {}});
    ASSERT_EQ(lists.size(), 4U);
    EXPECT_THAT(lists[0], ElementsAre(5, 3));
    EXPECT_THAT(lists[1], IsEmpty());
    EXPECT_THAT(lists[2], ElementsAre(7));
    EXPECT_THAT(lists[3], IsEmpty());
}

TEST(Components, AreCyclesAndSingleNodes) {
    // 2 > 0 > 1 > 2 is a cycle that leads into 3 > 4 > 3; 5 stands alone, 6 points to itself and to 0.
    const Adjacency adjacency = pointing({{1}, {2, 3}, {0}, {4}, {3}, {}, {6, 0}});
    const Components components = find_components(adjacency);
    EXPECT_THAT(members_of(components),
                ElementsAre(ElementsAre(3, 4), ElementsAre(0, 1, 2), ElementsAre(5), ElementsAre(6)));
    EXPECT_THAT(components.of, ElementsAre(1, 1, 1, 0, 0, 2, 3));
    EXPECT_THAT(layers_of(adjacency, components),
                ElementsAre(ElementsAre(0, 2), ElementsAre(1), ElementsAre(3)));
}

TEST(Components, OfNothingAreNone) {
    EXPECT_TRUE(find_components(pointing({})).of.empty());
    EXPECT_TRUE(layers_of(pointing({}), find_components(pointing({}))).empty());
}

TEST(Components, ThatPointToAFinishedOneAreApart) {
    // 2 points to what was finished before; that makes no cycle.
    EXPECT_THAT(members_of(find_components(pointing({{1}, {}, {1, 0}}))),
                ElementsAre(ElementsAre(1), ElementsAre(0), ElementsAre(2)));
}

TEST(Layers, AreAsLowAsTheyCanBe) {
    // 0 points to 3 at once and over 1 and 2: it stands three above it.
    const Adjacency adjacency = pointing({{3, 1}, {2}, {3}, {}, {3}});
    const Components components = find_components(adjacency);
    Lists layers = layers_of(adjacency, components);
    for (auto& layer : layers) {
        for (std::uint32_t& component : layer) component = components.members[component].front();
        std::ranges::sort(layer);
    }
    EXPECT_THAT(layers, ElementsAre(ElementsAre(3), ElementsAre(2, 4), ElementsAre(1), ElementsAre(0)));
}

/// Which nodes a path leads to, by the book.
std::vector<std::vector<bool>> reach(const Lists& lists) {
    std::vector<std::vector<bool>> leads(lists.size(), std::vector<bool>(lists.size(), false));
    for (std::size_t from = 0; from < lists.size(); ++from)
        for (const std::uint32_t to : lists[from]) leads[from][to] = true;
    for (std::size_t over = 0; over < lists.size(); ++over)
        for (std::size_t from = 0; from < lists.size(); ++from)
            for (std::size_t to = 0; to < lists.size(); ++to)
                if (leads[from][over] && leads[over][to]) leads[from][to] = true;
    return leads;
}

TEST(Components, HoldWhatLeadsToEachOtherInAnyGraph) {
    test::Dice dice(1);
    for (int turn = 0; turn < 300; ++turn) {
        Lists lists(static_cast<std::size_t>(dice.between(1, 10)));
        for (std::size_t i = dice.below(20); i > 0; --i)
            lists[dice.below(lists.size())].push_back(static_cast<std::uint32_t>(dice.below(lists.size())));
        const Adjacency adjacency = pointing(lists);
        const Components components = find_components(adjacency);
        const auto leads = reach(lists);
        for (std::uint32_t a = 0; a < lists.size(); ++a) {
            const auto there = components.members[components.of[a]];
            EXPECT_TRUE(std::ranges::is_sorted(there));
            for (std::uint32_t b = 0; b < lists.size(); ++b) {
                const bool together = a == b || (leads[a][b] && leads[b][a]);
                EXPECT_EQ(components.of[a] == components.of[b], together);
                EXPECT_EQ(std::ranges::count(there, b), together ? 1 : 0);
                EXPECT_TRUE(!leads[a][b] || components.of[b] <= components.of[a]);
            }
        }
    }
}

TEST(Components, OfALongChainAreFoundWithoutRecursion) {
    constexpr std::uint32_t nodes = 200'000;
    Lists chain(nodes);
    for (std::uint32_t node = 1; node < nodes; ++node) chain[node - 1].push_back(node);
    EXPECT_EQ(find_components(pointing(chain)).members.size(), nodes);
    chain.back().push_back(0);
    EXPECT_EQ(find_components(pointing(chain)).members.size(), 1U);
}

} // namespace
} // namespace maclint::flow
