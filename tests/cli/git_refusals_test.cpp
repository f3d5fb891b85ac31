//! Paths in a .git that lead to another server. They are told from others by their look, on every system.
#include "cli/gate/git_refusals.hpp"
#include "cli/input/git_folders.hpp"
#include "tests/support/folder.hpp"
#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::cli {
namespace {

using testing::HasSubstr;

struct ServerRow {
    std::string_view file; ///< from the repository
    std::string_view text;
    bool is_refused;
};

class GitRefusals : public testing::Test {
  protected:
    [[nodiscard]] bool refuses(const ServerRow& row) const {
        const test::TemporaryFolder folder;
        folder.write(std::string(row.file), row.text);
        const auto refused = refuse_other_servers({folder.path().string()});
        if (refused) {
            EXPECT_TRUE(refused->is_error());
            EXPECT_THAT(refused->message, HasSubstr("names a path on another server, '"));
        }
        return refused.has_value();
    }
};

TEST_F(GitRefusals, OfPathsOnAnotherServer) {
    if (test::run_shell("/", "git --version").status != 0) GTEST_SKIP() << "there is no git";
    for (const ServerRow& row : std::to_array<ServerRow>({
             {".git", "gitdir: //server/share/x\n", true},
             {".git", "gitdir: \\\\server\\share\\x\r\n", true},
             {".git", "gitdir: ../x\n", false},
             {".git/commondir", "//server/share/x\n", true},
             {".git/commondir", "../x\n", false},
             {".git/objects/info/alternates", "/x\n\n//server/share/objects\n", true},
             {".git/objects/info/alternates", R"("\134\134server\134share")", true},
             {".git/objects/info/alternates", "# //server/share\n../../y/objects\n", false},
             {".git/config", "[core]\nworktree = //server/share\n", true},
             {".git/config", "[core]\nworktree = ../x\n", false},
             {".git/config", "[include]\npath = \\\\\\\\server\\\\share\\\\x\n", true},
             {".git/config", "[include]\npath = \"//server/share/x\" ; no\n", true},
             {".git/config", "[include]\npath = :(optional)//server/share/x\n", true},
             {".git/config", "[includeIf \"gitdir:nowhere\"]\npath = //server/share/x\n", true},
             {".git/config", "[include]\npath = \\\n//server/share/x\n", true},
             {".git/config", "[extensions]\nrefStorage = \"reftable:////server/share\"\n", true},
             {".git/config", "[extensions]\nrefStorage = \"files:///x\"\n", false},
             {".git/config", "[remote \"x\"]\nurl = //server/share/x\n", false}, // it is not fetched from
             {".git/config", "[include]\npath\n", false},
             {".git/config.worktree", "[include]\npath = //server/share/x\n", true},
         }))
        EXPECT_EQ(refuses(row), row.is_refused) << row.file << "\n" << row.text;
}

TEST_F(GitRefusals, AreSearchedThroughAllThatNameEachOther) {
    if (test::run_shell("/", "git --version").status != 0) GTEST_SKIP() << "there is no git";
    const test::TemporaryFolder folder;
    const auto refused = [&] { return refuse_other_servers({folder.path().string()}).has_value(); };
    folder.write(".git", "gitdir: own\n");
    folder.write("own/commondir", "../common\n");
    folder.write("common/config", "[include]\npath = ../a.cfg\n[include]\npath = ~/x\n");
    folder.write("a.cfg", "[include]\npath = b.cfg\n");
    folder.write("b.cfg", "[include]\npath = a.cfg\n");
    folder.write("common/objects/info/alternates", "../../more\n");
    folder.write("more/info/alternates", "../common/objects\n");
    EXPECT_FALSE(refused());
    folder.write("b.cfg", "[include]\npath = //server/share/c.cfg\n");
    EXPECT_TRUE(refused());
    folder.write("b.cfg", "");
    EXPECT_FALSE(refused());
    folder.write("more/info/alternates", "//server/share/objects\n");
    EXPECT_TRUE(refused());
    folder.write("more/info/alternates", std::string(2'000'000, '#') + "\n//server/share/objects\n");
    EXPECT_TRUE(refused()) << "too large to look through";
}

TEST(GitFolders, AreFoundByTheirNames) {
    const test::TemporaryFolder folder;
    const auto& root = folder.path();
    folder.write(".git/HEAD", "");
    EXPECT_EQ(git_folders_of(root).own, folder.path() / ".git");
    EXPECT_EQ(git_folders_of(root).common, folder.path() / ".git");
    folder.write("tree/.git", "gitdir: " + root.string() + "/.git/worktrees/tree\n");
    folder.write(".git/worktrees/tree/commondir", "../..\n");
    const auto [own, common] = git_folders_of(root / "tree");
    EXPECT_EQ(own, folder.path() / ".git/worktrees/tree");
    EXPECT_EQ(common.lexically_normal(), folder.path() / ".git/");
}

/// A second line is one of the path, as git has it: otherwise git and maclint would look at two folders.
TEST(GitFolders, AreNamedByTheWholeText) {
    const test::TemporaryFolder folder;
    folder.write(".git", "gitdir: a\nb\r\n\n");
    EXPECT_EQ(git_folders_of(folder.path()).own, folder.path() / "a\nb");
    EXPECT_EQ(path_named_in("gitdir: a\r\n", "gitdir: "), "a");
    EXPECT_EQ(path_named_in("../..\n", ""), "../..");
    EXPECT_EQ(path_named_in("x: a", "gitdir: "), "");
    EXPECT_EQ(path_named_in(std::string_view("gitdir: a\0b\n", 12), "gitdir: "), "a");
}

} // namespace
} // namespace maclint::cli
