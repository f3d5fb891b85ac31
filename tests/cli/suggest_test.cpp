//! Guessing what a mistyped word means.
#include "cli/suggest.hpp"
#include "rules/listed.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::cli {
namespace {

using testing::Eq;
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
