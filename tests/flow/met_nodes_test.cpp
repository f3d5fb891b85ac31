//! Nodes that are met stay met, few of them or many.
#include "analyzer/flow/met_nodes.hpp"

#include <cstddef>
#include <cstdint>

#include <gtest/gtest.h>

namespace maclint::flow {
namespace {

/// Meets every third node, and asks for all after each hundredth.
void meet_every_third_of(std::uint32_t nodes) {
    MetNodes met(nodes);
    const auto expect_those_before = [&](std::uint32_t end) {
        std::size_t wrong = 0;
        for (std::uint32_t node = 0; node < nodes; ++node)
            wrong += met.contains(node) != (node < end && node % 3 == 0) ? 1 : 0;
        EXPECT_EQ(wrong, 0U) << "of " << nodes << " nodes, met before " << end;
    };
    expect_those_before(0);
    for (std::uint32_t node = 0; node < nodes; node += 3) {
        met.insert(node);
        met.insert(node); // once more is no other
        if (node % 300 == 0) expect_those_before(node + 1);
    }
    expect_those_before(nodes);
}

TEST(MetNodes, AreTheSameInSmallAndInLargeGraphs) {
    for (const std::uint32_t nodes : {1U, 64U, 4096U, 4097U, 20'000U}) meet_every_third_of(nodes);
}

TEST(MetNodes, AreNoneOfTheWalkBeforeNorOfTheOneAround) {
    MetNodes around(10);
    around.insert(3);
    for (const std::size_t nodes : {10U, 20U}) {
        MetNodes within(nodes);
        EXPECT_FALSE(within.contains(3));
        within.insert(4);
    }
    MetNodes later(20);
    EXPECT_FALSE(later.contains(3));
    EXPECT_FALSE(later.contains(4));
    EXPECT_TRUE(around.contains(3));
    EXPECT_FALSE(around.contains(4));
}

} // namespace
} // namespace maclint::flow
