//! Patterns for paths.
#include "cli/config/glob.hpp"

#include <string>

#include <gtest/gtest.h>

namespace maclint::cli {
namespace {

TEST(Glob, WithoutASlashIsTriedOnEveryName) {
    EXPECT_TRUE(matches("*.nc", "lathe/O1.nc"));
    EXPECT_TRUE(matches("old", "mill/old/O1.nc"));
    EXPECT_FALSE(matches("old", "mill/older/O1.nc"));
}

TEST(Glob, WithASlashStartsAtTheFolderOfTheConfiguration) {
    EXPECT_TRUE(matches("lathe/*.nc", "lathe/O1.nc"));
    EXPECT_FALSE(matches("lathe/*.nc", "old/lathe/O1.nc"));
    EXPECT_FALSE(matches("lathe/*.nc", "lathe/a/O1.txt"));
    EXPECT_TRUE(matches("lathe/", "lathe/a/O1.txt"));
}

TEST(Glob, TwoStarsCrossFolders) {
    EXPECT_TRUE(matches("lathe/**", "lathe/a/b/O1.nc"));
    EXPECT_TRUE(matches("**/probe/*.nc", "a/b/probe/O1.nc"));
    EXPECT_TRUE(matches("**/probe/*.nc", "probe/O1.nc"));
    EXPECT_TRUE(matches("a/**/z/O1.nc", "a/z/z/O1.nc"));
    EXPECT_FALSE(matches("lathe/**", "mill/lathe/O1.nc"));
}

TEST(Glob, KnowsQuestionMarksAndSets) {
    EXPECT_TRUE(matches("O91??", "O9100"));
    EXPECT_FALSE(matches("O91??", "O910"));
    EXPECT_TRUE(matches("O[0-8]*", "O8000.nc"));
    EXPECT_FALSE(matches("O[!0-8]*", "O8000.nc"));
    EXPECT_TRUE(matches("a[.nc", "a[.nc"));
}

TEST(Glob, OfAllNamesMatchesTheWholePath) {
    const auto all = [](const std::vector<std::string>& pattern, const std::vector<std::string_view>& path) {
        return matches_names(pattern, path);
    };
    EXPECT_TRUE(all({"a", "*.nc"}, {"a", "O1.nc"}));
    EXPECT_FALSE(all({"a"}, {"a", "O1.nc"}));
    EXPECT_TRUE(all({"a", "**"}, {"a", "O1.nc"}));
    EXPECT_FALSE(all({"a", "**"}, {"a"}));
    EXPECT_TRUE(all({"a", "**", "b"}, {"a", "b"}));
    EXPECT_TRUE(all({"**", "b"}, {"a", "b", "b"}));
    EXPECT_FALSE(all({"**", "b"}, {"b", "a"}));
}

TEST(Glob, EndsSoonWhateverThePatternIs) {
    const std::string pattern = std::string(2000, '*') + "x";
    EXPECT_FALSE(matches(pattern, std::string(20'000, 'a')));
}

} // namespace
} // namespace maclint::cli
