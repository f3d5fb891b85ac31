//! Blocks that no path reaches, arguments that no block reads.
#include "analyzer/queries/unreached_regions.hpp"
#include "analyzer/queries/unread_arguments.hpp"
#include "tests/support/analysed.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::queries {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::string> regions_of(const std::string& text) {
    const auto workspace = test::analyse_fanuc(text);
    const ProgramAnalysis& analysis = workspace->programs().front();
    std::vector<std::string> found;
    for (const UnreachedRegion& region : unreached_regions(analysis))
        found.push_back(std::string(analysis.program().slice(region.head)) +
                        (region.leaves ? " leaves" : "") + (region.moves ? " moves" : "") +
                        (region.is_alarm ? " alarm" : "") + (region.is_meant ? " meant" : "") +
                        (region.is_explained ? " explained" : ""));
    return found;
}

TEST(UnreachedRegions, TellWhatStandsInThemAndWhy) {
    EXPECT_THAT(regions_of("O1\nG0 X1.\nM30\nN9 X2.\nX3.\nM30\n"), ElementsAre("N9 X2. leaves moves"));
    EXPECT_THAT(regions_of("O1\nGOTO9(LATER)\nX2.\nN9 M30\n"), ElementsAre("X2. moves meant"));
    EXPECT_THAT(regions_of("O1\nM99\nN9 #3000=1\n"), ElementsAre("N9 #3000=1 alarm"));
    EXPECT_THAT(regions_of("O1\nM99\n(GOTO8, GOTO 9)\nGOTO7\nN9 #3000=1\nN7 M99\n"),
                ElementsAre("GOTO7 leaves"));
    EXPECT_THAT(regions_of("O1\nIF[#1EQ2]GOTO8\nM99\nN9 X2.\n"), ElementsAre("N9 X2. moves explained"));
    // The rest of a jump's own block is no block.
    EXPECT_THAT(regions_of("O1\nGOTO9 X2.\nN9 M30\n"), IsEmpty());
}

TEST(UnreadArguments, TellOfAllCallsThatPassThem) {
    const auto workspace =
        test::analyse_fanuc("O1\nG65 P2 X1. Z2.\nG65 P2 X1. Z3.\nM30\nO2\n#24=#24+1\nG0 X#24\nM99\n");
    const auto found = unread_arguments(workspace->programs().front());
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found.front().argument->address, "Z");
    EXPECT_EQ(found.front().others.size(), 1U);
    EXPECT_FALSE(found.front().overwritten);
}

} // namespace
} // namespace maclint::queries
