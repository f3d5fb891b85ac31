//! Blocks that no path reaches, what cannot be read among them, arguments that no block reads.
#include "analyzer/queries/calls/unread_arguments.hpp"
#include "analyzer/queries/paths/unreached_regions.hpp"
#include "analyzer/queries/paths/unreached_text.hpp"
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
                        (region.alarms.empty() ? "" : " alarms") + (region.is_alarm ? " straight" : "") +
                        (region.is_meant ? " meant" : "") + (region.is_explained ? " explained" : ""));
    return found;
}

TEST(UnreachedRegions, TellWhatStandsInThemAndWhy) {
    EXPECT_THAT(regions_of("O1\nG0 X1.\nM30\nN9 X2.\nX3.\nM30\n"), ElementsAre("N9 X2. leaves moves"));
    EXPECT_THAT(regions_of("O1\nGOTO9(LATER)\nX2.\nN9 M30\n"), ElementsAre("X2. moves meant"));
    EXPECT_THAT(regions_of("O1\nM99\nN9 #3000=1\n"), ElementsAre("N9 #3000=1 alarms straight"));
    EXPECT_THAT(regions_of("O1\nM99\n(GOTO8, GOTO 9)\nGOTO7\nN9 #3000=1\nN7 M99\n"),
                ElementsAre("GOTO7 leaves alarms"));
    // The alarm in front of it is not its own.
    EXPECT_THAT(regions_of("O1\nIF[#1EQ1]THEN#3000=1(NO)\nM99\nX#2\n"), ElementsAre("X#2 moves"));
    EXPECT_THAT(regions_of("O1\nIF[#1EQ2]GOTO8\nM99\nN9 X2.\n"), ElementsAre("N9 X2. moves explained"));
    // The rest of a jump's own block is no block.
    EXPECT_THAT(regions_of("O1\nGOTO9 X2.\nN9 M30\n"), IsEmpty());
    EXPECT_THAT(regions_of("O1\nGOTO9 X2.\n#1=3\nN9 M30\n"), IsEmpty()); // nor begins what follows it
}

TEST(UnreachedRegions, MayJumpToEachOther) {
    EXPECT_THAT(regions_of("O1\nGOTO7\nN5 X1.\nGOTO6\nN7 Y1.\nGOTO8\nN6 X2.\nGOTO5\nN8 M30\n"),
                ElementsAre("N5 X1. moves", "N6 X2. moves"));
}

TEST(UnreachedRegions, AreUnknownWhereLoopsDoNotMatch) {
    EXPECT_THAT(regions_of("O1\nGOTO9\nX2.\nN9 WHILE[#1LT5]DO1\n#1=#1+1\nEND1\nM30\n"),
                ElementsAre("X2. moves"));
    EXPECT_THAT(regions_of("O1\nGOTO9\nX2.\nN9 WHILE[#1LT5]DO1\n#1=#1+1\nM30\n"), IsEmpty());
}

TEST(UnreachedRegions, AreNamedByOtherTextThanTheirOwn) {
    const auto named = [](const std::string& text) {
        const auto workspace = test::analyse_fanuc(text);
        std::vector<bool> found;
        for (const UnreachedRegion& region : unreached_regions(workspace->programs().front()))
            found.push_back(region.is_named);
        return found;
    };
    EXPECT_THAT(named("O1\n(LOW: N801, ELSE n802)\nM99\nN801 #3000=1(N801)\n"), ElementsAre(true));
    EXPECT_THAT(named("O1\n(LOW: N0801)\nM99\nN801 #3000=1\n"), ElementsAre(true));
    EXPECT_THAT(named("O1\n(LOW: N8012)\nM99\nN801 #3000=1(SEE N801)\n"), ElementsAre(false));
}

/// The blocks that nothing reaches around each piece of text that cannot be read.
std::vector<std::string> unreached_around(const std::string& text) {
    const auto workspace = test::analyse_fanuc(text);
    const ProgramAnalysis& analysis = workspace->programs().front();
    std::vector<std::string> found;
    for (const UnreachedText& unreached : unreached_text(analysis))
        found.emplace_back(analysis.program().slice(unreached.region));
    return found;
}

TEST(UnreachedText, StandsAmongAllTheBlocksThatNothingReaches) {
    EXPECT_THAT(unreached_around("O1\nGOTO5\n#1=1\n------\n#2=2\n#3=3\nN5 X1.\nM30\n"),
                ElementsAre("#1=1\n------\n#2=2\n#3=3"));
    EXPECT_THAT(unreached_around("O1\nX1.\nM30\n------\n#2=2\n"), ElementsAre("------\n#2=2"));
    EXPECT_THAT(unreached_around("O1\nGOTO5\n------\n#1=1\n------\nN5 X1.\nM30\n"),
                ElementsAre("------\n#1=1\n------", "------\n#1=1\n------"));
    EXPECT_THAT(unreached_around("O1\nX1.\n------\nM30\n"), IsEmpty());
    EXPECT_THAT(unreached_around("O1\nGOTO5\n#1=1\nN5 ------\nM30\n"), IsEmpty());
    // The block begins with the jump, which is reached.
    EXPECT_THAT(unreached_around("GOTO9 X1. Y\nN9 M30\n"), IsEmpty());
    // Of another program.
    EXPECT_THAT(unreached_around("O1\nX1.\nM30\nO2\nGOTO5\n------\nN5 M30\n"), IsEmpty());
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

/// The addresses that the first program passes for nothing, each with the number of other calls.
std::vector<std::string> unread_of_first(const std::string& text) {
    const auto workspace = test::analyse_fanuc(text);
    std::vector<std::string> found;
    for (const UnreadArgument& unread : unread_arguments(workspace->programs().front()))
        found.push_back(std::string(unread.argument->address) + std::to_string(unread.others.size()));
    return found;
}

TEST(UnreadArguments, AreToldOfTheFirstCallThatSurelyPassesThem) {
    const std::string reader = "O2\nG0 X#24 Z#6\nM99\n";
    EXPECT_THAT(unread_of_first("O1\nG65 P2 X1. D3.\nG65 P2 X1. D4.\nM30\n" + reader), ElementsAre("D1"));
    // Behind K a second I may mean #7 as well, which is D.
    EXPECT_THAT(unread_of_first("O1\nG65 P2 X1. K1. I2.\nG65 P2 X1. D3.\nM30\n" + reader), ElementsAre("D0"));
    // A call that belongs to a cycle.
    EXPECT_THAT(unread_of_first("O2\nIF[#24EQ1]GOTO5\nG65 P2 X1. Z3.\nN5 M99\n"), IsEmpty());
    const auto workspace =
        test::analyse_fanuc("O2\nIF[#24EQ1]GOTO5\nG65 P2 X1. Z3.\nN5 M99\nO1\nG65 P2 X1. Z2.\nM30\n");
    const auto found = unread_arguments(workspace->programs().back());
    ASSERT_EQ(found.size(), 1U);
    EXPECT_THAT(found.front().others, IsEmpty());
}

TEST(UnreadArguments, AreToldInTheFirstProgramThatPassesThem) {
    const auto workspace = test::analyse_fanuc("O2\nG0 X#24\nM99\nO1\nG65 P2 X1.\nG65 P2 X1. Z2.\nM30\n"
                                               "O3\nG65 P2 Z2.\nM30\n");
    EXPECT_EQ(unread_arguments(workspace->programs()[1]).size(), 1U);
    EXPECT_EQ(unread_arguments(workspace->programs()[1]).front().others.size(), 1U);
    EXPECT_THAT(unread_arguments(workspace->programs()[2]), IsEmpty());
}

} // namespace
} // namespace maclint::queries
