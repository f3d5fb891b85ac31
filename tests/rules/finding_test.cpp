//! What a finding takes as its fix.
#include "rules/finding.hpp"

#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

std::shared_ptr<const Source> source(std::string path) {
    return std::make_shared<const Source>(Source::from_bytes(std::move(path), "0123456789"));
}

/// The spans that the finding keeps of a fix with these; none when it refuses it.
std::vector<std::pair<Offset, Offset>> kept(std::vector<Edit> edits) {
    Finding finding{};
    finding.offer({"Change it", Applicability::safe, std::move(edits)});
    std::vector<std::pair<Offset, Offset>> spans;
    if (finding.fix)
        for (const Edit& edit : finding.fix->edits) spans.emplace_back(edit.span.begin, edit.span.end);
    return spans;
}

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

TEST(Fix, EditsAreInTheOrderOfTheText) {
    const auto a = source("A.nc");
    const auto b = source("B.nc");
    EXPECT_THAT(kept({{a, {4, 6}, "x"}, {a, {0, 2}, ""}}), ElementsAre(Pair(0, 2), Pair(4, 6)));
    EXPECT_THAT(kept({{b, {0, 1}, "x"}, {a, {5, 6}, ""}}), ElementsAre(Pair(5, 6), Pair(0, 1)));
}

TEST(Fix, EditsOfTheSameBytesAreRefused) {
    const auto a = source("A.nc");
    const auto b = source("B.nc");
    EXPECT_THAT(kept({{a, {0, 3}, "x"}, {a, {2, 4}, "y"}}), IsEmpty());
    EXPECT_THAT(kept({{a, {0, 9}, "x"}, {a, {2, 4}, "y"}, {a, {9, 10}, "z"}}), IsEmpty());
    EXPECT_THAT(kept({{a, {3, 3}, "x"}, {a, {3, 3}, "y"}}), IsEmpty()) << "which comes first?";
    EXPECT_THAT(kept({{a, {3, 3}, "x"}, {a, {3, 5}, "y"}}), IsEmpty()) << "which comes first?";
    EXPECT_THAT(kept({{a, {0, 3}, "x"}, {a, {3, 4}, "y"}}), ElementsAre(Pair(0, 3), Pair(3, 4)));
    EXPECT_THAT(kept({{a, {0, 3}, "x"}, {b, {0, 3}, "y"}}), ElementsAre(Pair(0, 3), Pair(0, 3)));
}

TEST(Fix, OneThatChangesNothingIsNone) { EXPECT_THAT(kept({}), IsEmpty()); }

} // namespace
} // namespace maclint
