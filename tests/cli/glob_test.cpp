//! Patterns for paths.
#include "cli/config/glob_set.hpp"
#include "tests/support/dice.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::cli {
namespace {

bool matches(const std::string& pattern, const std::string& path) {
    return GlobSet({{pattern, "/shop"}}).takes("/shop/" + path);
}

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

TEST(Glob, TwoStarsAtTheEndStandForOneNameAtLeast) {
    EXPECT_FALSE(matches("lathe/**", "lathe"));
    EXPECT_TRUE(matches("lathe/**/**", "lathe/O1.nc"));
    EXPECT_TRUE(matches("**/**", "O1.nc"));
    EXPECT_TRUE(matches("**", "a/O1.nc"));
}

TEST(Glob, IsRelativeToItsOwnFolder) {
    const GlobSet globs({{"*.nc", "/shop/a"}, {"a/*.nc", "/shop"}, {"b/../*.nc", "/shop"}, {"", "/shop"}});
    EXPECT_THAT(globs.that_take("/shop/a/O1.nc"), testing::ElementsAre(0, 1));
    EXPECT_THAT(globs.that_take("/shop/O1.nc"), testing::ElementsAre(0)); // as it may be named from there
    EXPECT_THAT(globs.that_take("/shop"), testing::IsEmpty());
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

using Names = std::span<const std::string_view>;

/// As the documentation says it, one try after the other.
bool leads_to(Names pattern, Names names) {
    if (pattern.empty()) return true;
    const Names rest = pattern.subspan(1);
    if (pattern.front() != "**")
        return !names.empty() && matches_name(pattern.front(), names.front()) &&
               leads_to(rest, names.subspan(1));
    if (rest.empty()) return !names.empty();
    return leads_to(rest, names) || (!names.empty() && leads_to(pattern, names.subspan(1)));
}

bool by_definition(std::string_view pattern, std::string_view path) {
    const auto wanted = cli::names_of(pattern);
    const auto names = cli::names_of(path);
    if (pattern.substr(0, pattern.size() - 1).find('/') != std::string_view::npos)
        return leads_to(wanted, names);
    return std::ranges::any_of(names, [&](const auto& name) { return matches_name(wanted.front(), name); });
}

TEST(Glob, ManyTakeWhatEachOfThemTakes) {
    test::Dice dice(32);
    const std::vector<std::string> parts = {"a",  "b",   "ab", "**", "**",    "*",     "a*",   "*b",
                                            "?b", "a?*", "[a", "a]", "[!a]*", "a*b.n", "*.nc", "*a*"};
    const std::vector<std::string> words = {"a", "b", "ab", "aab", "[a", "a]", "*b", "a.nc", "ab.n", "x"};
    const auto path_of = [&](const std::vector<std::string>& names) {
        std::string path = dice.one_of(names);
        for (std::size_t more = dice.below(4); more > 0; --more) path += "/" + dice.one_of(names);
        return path;
    };
    std::size_t taken = 0;
    for (int round = 0; round < 2000; ++round) {
        std::vector<Glob> globs;
        for (int i = 0; i < 8; ++i) globs.push_back({path_of(parts) + (dice.one_in(5) ? "/" : ""), "/shop"});
        const GlobSet set(globs);
        for (int i = 0; i < 8; ++i) {
            const std::string path = path_of(words);
            std::vector<std::size_t> expected;
            for (std::size_t k = 0; k < globs.size(); ++k)
                if (by_definition(globs[k].pattern, path)) expected.push_back(k);
            taken += expected.size();
            ASSERT_EQ(set.that_take("/shop/" + path), expected) << path;
        }
    }
    EXPECT_GT(taken, 20'000U); // of 128,000: neither none nor all
    EXPECT_LT(taken, 100'000U);
}

TEST(Glob, EndsSoonWhateverThePatternIs) {
    const std::string pattern = std::string(2000, '*') + "x";
    EXPECT_FALSE(matches(pattern, std::string(20'000, 'a')));
}

} // namespace
} // namespace maclint::cli
