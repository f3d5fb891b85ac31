//! Spans: half-open ranges of bytes.
#include "analyzer/source/span.hpp"

#include <gtest/gtest.h>

namespace maclint {
namespace {

TEST(Spans, ContainTheirBeginButNotTheirEnd) {
    constexpr Span span{2, 5};
    EXPECT_EQ(span.length(), 3U);
    EXPECT_TRUE(span.contains(2));
    EXPECT_FALSE(span.contains(5));
    EXPECT_FALSE((Span{2, 2}).contains(2));
}

TEST(Spans, CoverThemselvesAndTheEmptySpanAtTheirEnd) {
    constexpr Span span{2, 5};
    EXPECT_TRUE(span.covers(span));
    EXPECT_TRUE(span.covers({5, 5}));
    EXPECT_FALSE(span.covers({4, 6}));
}

TEST(Spans, OverlapOnlyWhereTheyShareAByte) {
    EXPECT_TRUE((Span{2, 5}).overlaps({4, 9}));
    EXPECT_FALSE((Span{2, 5}).overlaps({5, 9}));
}

TEST(Spans, StandInTheOrderOfTheFile) { EXPECT_LT((Span{2, 5}), (Span{2, 6})); }

TEST(Spans, JoinToTheSmallestThatCoversBoth) { EXPECT_EQ(join({7, 9}, {2, 3}), (Span{2, 9})); }

} // namespace
} // namespace maclint
