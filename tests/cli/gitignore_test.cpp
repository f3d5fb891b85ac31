//! What git passes over: our reading of its rules, and git's own verdict where git is there.
#include "cli/input/gitignore.hpp"
#include "tests/support/folder.hpp"
#include "tests/support/process.hpp"

#include <algorithm>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::cli {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> names_of(std::string_view line) {
    const auto rules = read_ignore_rules(line);
    return rules.size() == 1 ? rules.front().names : std::vector<std::string>{"no rule"};
}

TEST(GitIgnore, ReadsLinesAsGitDoes) {
    EXPECT_THAT(read_ignore_rules("# a comment\n\n   \n!\n/\n"), IsEmpty());
    EXPECT_THAT(names_of("\xEF\xBB\xBFold.nc  \r\n"), ElementsAre("old.nc"));
    EXPECT_THAT(names_of("old\\ "), ElementsAre("old "));
    EXPECT_THAT(names_of("\\#1"), ElementsAre("#1"));
    EXPECT_THAT(names_of("a/**/b*/"), ElementsAre("a", "**", "b*"));
    EXPECT_THAT(names_of("\\*[]a-]\\?"), ElementsAre("[*][]-a][?]"));
    EXPECT_THAT(names_of("[^[:digit:]!]"), ElementsAre("[!0-9!]"));
    EXPECT_THAT(names_of("[!!]x[!]"), ElementsAre("no rule")); // an open bracket matches nothing
    EXPECT_THAT(names_of("[\\!]"), ElementsAre("!"));
    EXPECT_THAT(names_of("a\\"), ElementsAre("no rule"));
    const auto rules = read_ignore_rules("!/keep/\nout");
    EXPECT_TRUE(rules[0].wanted && rules[0].anchored && rules[0].folders_only);
    EXPECT_FALSE(rules[1].wanted || rules[1].anchored || rules[1].folders_only);
}

class GitIgnoreFolders : public testing::Test {
  protected:
    void write_all(const std::vector<std::string>& files) const {
        for (const std::string& file : files) folder.write(file, "O1\n");
    }
    [[nodiscard]] bool ignored(const std::string& path) const {
        std::error_code none;
        GitIgnore git;
        const auto whole = std::filesystem::canonical(folder.path()) / path;
        return git.ignores_path(whole.string(), std::filesystem::is_directory(whole, none));
    }

    test::TemporaryFolder folder;
};

TEST_F(GitIgnoreFolders, AreOfARepositoryOnly) {
    folder.write(".gitignore", "*.nc\n");
    folder.write("O1.nc", "O1\n");
    EXPECT_FALSE(ignored("O1.nc"));
    folder.write(".git/HEAD", "");
    EXPECT_TRUE(ignored("O1.nc"));
    folder.write("inner/.git/HEAD", ""); // another repository
    folder.write("inner/O1.nc", "O1\n");
    EXPECT_FALSE(ignored("inner/O1.nc"));
}

TEST_F(GitIgnoreFolders, HaveRulesOfTheWorkTreeBesideTheRepository) {
    folder.write("main/.git/info/exclude", "*.nc\n");
    folder.write("main/.git/worktrees/other/commondir", "../..\n");
    folder.write("other/.git", "gitdir: ../main/.git/worktrees/other\n");
    folder.write("other/O1.nc", "O1\n");
    EXPECT_TRUE(ignored("other/O1.nc"));
}

TEST_F(GitIgnoreFolders, ThatWereAskedForHaveTheirOwnRulesOnly) {
    folder.write(".git/HEAD", "");
    folder.write(".gitignore", "out/\n*.tap\n");
    folder.write("out/.gitignore", "*.min\n");
    const std::string out = (std::filesystem::canonical(folder.path()) / "out").string();
    GitIgnore git;
    git.ask_for(out);
    EXPECT_FALSE(git.ignores(out, "O1.tap", false));
    EXPECT_TRUE(git.ignores(out, "O1.min", false));
    EXPECT_TRUE(git.ignores(std::filesystem::path(out).parent_path().string(), "out", true));
}

/// Rules of all kinds, in files at several depths.
const std::vector<std::pair<std::string, std::string>> rule_files = {
    {".gitignore",
     "# comment\n*.tap\n!keep.tap\n/top.nc\nout/\n!out/never.nc\ndocs/*.nc\na/**/z.nc\n**/deep/x.nc\n"
     "lib/**\n[0-3]?.nc\n[!a-m]q.nc\n\\!bang.nc\nblank\\ .nc \ntrail.nc   \nx[[:digit:]].nc\n"
     "star\\*.nc\nlink\nfold\nm**n.nc\r\n[]-]s.nc\n[^x]t.nc\n"},
    {"sub/.gitignore", "!*.tap\n/own.nc\nfold/\n"},
    {"sub/more/.gitignore", "*.tap\n"},
    {"order/.gitignore",
     "a.nc\n!*.nc\n/b.nc\n!x/c.nc\nx/c.nc\nx/d.nc\n!d.nc\n*.min\n!e.min\ne.min/\nf.min\n!/f.min\ng.tap/\n"},
    {".git/info/exclude", "excluded.nc\n"}};

const std::vector<std::string> paths = {"a.tap",           "keep.tap",
                                        "top.nc",          "sub/top.nc",
                                        "out/never.nc",    "out/a.nc",
                                        "sub/out/a.nc",    "docs/a.nc",
                                        "docs/b/a.nc",     "sub/docs/a.nc",
                                        "a/z.nc",          "a/b/z.nc",
                                        "a/b/c/z.nc",      "a/zz.nc",
                                        "deep/x.nc",       "q/deep/x.nc",
                                        "lib/a.nc",        "lib/b/a.nc",
                                        "0a.nc",           "4a.nc",
                                        "zq.nc",           "bq.nc",
                                        "!bang.nc",        "bang.nc",
                                        "blank .nc",       "blank.nc",
                                        "trail.nc",        "x1.nc",
                                        "xx.nc",           "star*.nc",
                                        "starry.nc",       "sub/a.tap",
                                        "sub/more/a.tap",  "sub/own.nc",
                                        "sub/more/own.nc", "own.nc",
                                        "sub/fold/a.nc",   "fold",
                                        "excluded.nc",     "sub/excluded.nc",
                                        "plain.nc",        "m1n.nc",
                                        "mn.nc",           "order/a.nc",
                                        "order/b.nc",      "order/x/b.nc",
                                        "order/x/c.nc",    "order/x/d.nc",
                                        "order/d.nc",      "order/e.min",
                                        "order/x/e.min",   "order/f.min",
                                        "order/x/f.min",   "order/g.tap/a.nc",
                                        "order/y/g.tap",   "]s.nc",
                                        "-s.nc",           "as.nc",
                                        "xt.nc",           "yt.nc"};

TEST_F(GitIgnoreFolders, PassOverWhatGitPassesOver) {
    if (test::run_shell(folder.path().string(), "git init -q . 2>&1").status != 0) GTEST_SKIP() << "no git";
    for (const auto& [name, text] : rule_files) folder.write(name, text);
    write_all(paths);
    std::string list;
    for (const std::string& path : paths) list += path + "\n";
    folder.write("list", list);
    const auto git = test::run_shell(
        folder.path().string(), "git -c core.excludesFile=/dev/null check-ignore --no-index --stdin <list");
    ASSERT_LE(git.status, 1) << git.err;
    std::vector<std::string> expected, found;
    std::istringstream lines(git.out);
    for (std::string line; std::getline(lines, line);) expected.push_back(line);
    for (const std::string& path : paths)
        if (ignored(path)) found.push_back(path);
    EXPECT_EQ(found, expected);
    EXPECT_GT(found.size(), 20U);
}

TEST_F(GitIgnoreFolders, WithTooManyWildcardsPassNothingOverAndAreNoted) {
    const auto wildcards = [](std::size_t count) {
        std::string text;
        for (std::size_t i = 0; i < count; ++i) text += "*a" + std::to_string(i) + "c*\n";
        return text;
    };
    folder.write(".git/HEAD", "");
    folder.write(".gitignore", "*.nc\n" + wildcards(1998));
    folder.write("full/.gitignore", "!x*.nc\nO2.nc\n");
    folder.write("over/.gitignore", "!x*.nc\n*.tap\nO2.nc\n");
    const std::string top = std::filesystem::canonical(folder.path()).string();
    GitIgnore git;
    EXPECT_TRUE(git.ignores(top + "/full", "O2.nc", false));
    EXPECT_FALSE(git.ignores(top + "/full", "x1.nc", false));
    EXPECT_THAT(git.unread(), IsEmpty());
    for (const char* name : {"O2.nc", "x1.nc", "y.nc", "y.tap"})
        EXPECT_FALSE(git.ignores(top + "/over", name, false)) << name;
    ASSERT_EQ(git.unread().size(), 1U);
    EXPECT_EQ(git.unread().front().message, "holds, with the files above it, more than 2000 patterns with "
                                            "wildcards. What it names is checked.");
}

} // namespace
} // namespace maclint::cli
