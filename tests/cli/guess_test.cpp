//! Guessing what a mistyped or shortened word means.
#include "cli/text/guess.hpp"
#include "cli/text/shown.hpp"
#include "rules/listed.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::cli {
namespace {

using testing::ElementsAre;
using testing::Eq;
using testing::IsEmpty;
using testing::Optional;

const std::vector<std::string> rules = {"jump-into-loop", "jump-target-missing", "MAC303"};

TEST(Closest, FindsAWordWithLettersWrongMissingOrSwapped) {
    EXPECT_THAT(closest("jump-into-lop", rules), Optional(Eq("jump-into-loop")));
    EXPECT_THAT(closest("JUMP-INTO-LOPO", rules), Optional(Eq("jump-into-loop")));
    EXPECT_THAT(closest("mac330", rules), Optional(Eq("MAC303")));
}

TEST(Closest, FindsNothingWhenAllIsFar) {
    EXPECT_EQ(closest("spindle", rules), std::nullopt);
    EXPECT_EQ(closest("", rules), std::nullopt);
    EXPECT_EQ(closest("MAC999", rules), std::nullopt); // two digits away
    EXPECT_EQ(closest(std::string(100'000, 'J'), rules), std::nullopt);
}

TEST(Likely, TriesBeginningsAndWholeWordsBeforeLetters) {
    const std::vector<std::string> controls = {"fanuc-0i-c", "fanuc-0i-c-lathe", "fanuc-0i-d", "fanuc-16i",
                                               "haas"};
    EXPECT_THAT(likely("fanuc-0i", controls), ElementsAre("fanuc-0i-c", "fanuc-0i-d"));
    EXPECT_THAT(likely("0I", controls), IsEmpty()) << "two letters say nothing";
    EXPECT_THAT(likely("16i", controls), ElementsAre("fanuc-16i"));
    EXPECT_THAT(likely("haas-vf2", controls), ElementsAre("haas"));
    EXPECT_THAT(likely("hass", controls), ElementsAre("haas"));
    const std::vector<std::string> options = {"--statistics", "--select", "--since"};
    EXPECT_THAT(likely("--stats", options), ElementsAre("--statistics"));
    EXPECT_THAT(likely("--stat", options), ElementsAre("--statistics"));
    EXPECT_THAT(likely("loop", rules), ElementsAre("jump-into-loop"));
}

TEST(Likely, NamesNoneWhereManyAreAsLikely) {
    const std::vector<std::string> many = {"loop-a", "loop-b", "loop-c", "loop-d"};
    EXPECT_THAT(likely("loop", many), IsEmpty());
    EXPECT_EQ(did_you_mean("loop", many, "See the list."), " See the list.");
    EXPECT_EQ(did_you_mean("jump", rules, ""), " Did you mean 'jump-into-loop' or 'jump-target-missing'?");
}

TEST(Listed, WritesAListAsASentenceDoes) {
    EXPECT_EQ(rules::listed(std::vector<std::string>{"a"}, " and "), "a");
    EXPECT_EQ(rules::listed(std::vector<std::string>{"a", "b", "c"}, " and "), "a, b and c");
}

TEST(Shown, EscapesWhatATerminalWouldActOn) {
    EXPECT_EQ(shown("O1\x1B[2J.nc"), "O1\\x1B[2J.nc");
    EXPECT_EQ(shown("gr\xF6\xDF"
                    "e.nc"),
              "größe.nc");
}

} // namespace
} // namespace maclint::cli
