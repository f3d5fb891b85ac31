//! The one sort behind the lists of facts.
#include "analyzer/dataflow/facts/fact_order.hpp"

#include <cstdint>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::dataflow {
namespace {

struct Noted {
    std::uint32_t node;
    char what;
    friend bool operator==(const Noted&, const Noted&) = default;
};

TEST(FactOrder, FactsOfOneNodeStayAsTheyWereFound) {
    std::vector<Noted> facts{{7, 'a'}, {2, 'b'}, {7, 'c'}, {2, 'd'}, {0xFFFFFFFF, 'e'}, {0, 'f'}, {7, 'g'}};
    put_in_order_of(facts, &Noted::node);
    EXPECT_THAT(facts, testing::ElementsAre(Noted{0, 'f'}, Noted{2, 'b'}, Noted{2, 'd'}, Noted{7, 'a'},
                                            Noted{7, 'c'}, Noted{7, 'g'}, Noted{0xFFFFFFFF, 'e'}));
    EXPECT_TRUE(is_in_order(facts, &Noted::node));
}

TEST(FactOrder, ListsOfNoneOrOneAreInOrder) {
    std::vector<Noted> facts;
    put_in_order_of(facts, &Noted::node);
    EXPECT_THAT(facts, testing::IsEmpty());
    facts.push_back({3, 'a'});
    EXPECT_TRUE(is_in_order(facts, &Noted::node));
}

} // namespace
} // namespace maclint::dataflow
