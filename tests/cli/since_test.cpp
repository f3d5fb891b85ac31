//! --since of the built executable, in repositories that git makes.
#include "tests/support/in_repository.hpp"

#include <filesystem>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace maclint::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

constexpr std::string_view bad = "%\nO1001\nGOTO 99\nN1 G0 X1.\nM30\n%\n";                   // line 3
constexpr std::string_view worse = "%\nO1001\nGOTO 99\nN1 G0 X1.\nG1 X1. F9. F8.\nM30\n%\n"; // line 5 is new
constexpr std::string_view elsewhere =
    "%\nO1001\nGOTO 99\nN1 G0 X1.\nG0 X2.\nM30\n%\n"; // nothing found there

class Since : public InRepository {
  protected:
    void SetUp() override {
        if (shell("git init -q . && git config user.name a && git config user.email a && "
                  "git config core.autocrlf false")
                .status != 0)
            GTEST_SKIP() << "there is no git";
        folder.write("O1001.nc", bad);
        commit();
    }

    void commit() const { ASSERT_EQ(shell("git add -A && git commit -q -m x").status, 0); }
    /// What is found since a revision, a line each, and the status.
    [[nodiscard]] std::string found(const std::string& arguments, const std::string& input = "") const {
        folder.write(".git/input", input);
        const Finished finished =
            shell("$maclint --format concise --quiet --select MAC301,MAC303,MAC559 " + arguments +
                  " < .git/input > .git/found; status=$?; sed 's/ .*//' .git/found; "
                  "exit $status");
        return finished.err + finished.out + std::to_string(finished.status);
    }
};

TEST_F(Since, ShowsWhatStandsInChangedLinesAndCountsTheRest) {
    folder.write("O1001.nc", worse);
    const Finished finished = shell("$maclint --since HEAD --format concise");
    EXPECT_EQ(finished.status, 1);
    EXPECT_THAT(finished.out, AllOf(StartsWith("O1001.nc:5:12: warning[MAC559]"), Not(HasSubstr(":3:"))));
    EXPECT_EQ(finished.err, "maclint: note: 1 finding not shown: it shows no line changed since 'HEAD'.\n");
    folder.write("O1001.nc", elsewhere);
    EXPECT_EQ(shell("$maclint --since HEAD --quiet").status, 0);
}

TEST_F(Since, LooksAtTheIndexAndAtOlderRevisions) {
    folder.write("O1001.nc", worse);
    ASSERT_EQ(shell("git add -A").status, 0);
    EXPECT_EQ(found("--since HEAD"), "O1001.nc:5:12:\n1");
    commit();
    EXPECT_EQ(found("--since HEAD"), "0");
    EXPECT_EQ(found("--since HEAD~1"), "O1001.nc:5:12:\n1");
    EXPECT_EQ(found("--since $(git rev-parse --short HEAD~1)"), "O1001.nc:5:12:\n1");
}

TEST_F(Since, AllOfANewFileHasChanged) {
    folder.write("O2.nc", bad);
    EXPECT_EQ(found("--since HEAD"), "O2.nc:3:1:\n1");
    folder.write(".gitignore", "O2.nc");
    EXPECT_EQ(found("--since HEAD --no-gitignore"), "O2.nc:3:1:\n1");
    ASSERT_EQ(shell("git add -f O2.nc").status, 0);
    EXPECT_EQ(found("--since HEAD --no-gitignore"), "O2.nc:3:1:\n1");
}

TEST_F(Since, NothingHasChangedInAFileThatWasOnlyRenamed) {
    ASSERT_EQ(shell("git config diff.renames false; mkdir new && git mv O1001.nc new/O7.nc").status, 0);
    EXPECT_EQ(found("--since HEAD"), "0");
    folder.write("new/O7.nc", worse);
    EXPECT_EQ(found("--since HEAD"), "new/O7.nc:5:12:\n1");
}

TEST_F(Since, AFileThatWasMovedIsTheSameThoughGitDoesNotKnowIt) {
    ASSERT_EQ(shell("mkdir new && mv O1001.nc new/O7.nc").status, 0);
    EXPECT_EQ(found("--since HEAD"), "0");
    EXPECT_EQ(found("--since HEAD new/O7.nc"), "0");
    folder.write("new/O8.nc", bad); // one of them is new
    EXPECT_EQ(found("--since HEAD"), "new/O8.nc:3:1:\n1");
    ASSERT_EQ(shell("rm new/O8.nc; git checkout O1001.nc").status, 0);
    EXPECT_EQ(found("--since HEAD"), "new/O7.nc:3:1:\n1"); // a copy: nothing is gone
}

TEST_F(Since, AFileThatIsNotCheckedOutIsNotGone) {
    folder.write("other/O2.nc", bad);
    commit();
    if (shell("git sparse-checkout set --no-cone /O1001.nc 2> .git/log").status != 0)
        GTEST_SKIP() << "this git cannot do that";
    ASSERT_FALSE(fs::exists(folder.path() / "other"));
    folder.write("O3.nc", bad);
    EXPECT_EQ(found("--since HEAD O3.nc"), "O3.nc:3:1:\n1");
}

TEST_F(Since, OfAPointerToALargeFileAllLinesHaveChanged) {
    const std::string pointer =
        "version https://git-lfs.github.com/spec/v1\noid sha256:" + std::string(64, '0') + "\nsize 39\n";
    folder.write("O1001.nc", pointer);
    folder.write("O2.nc", pointer);
    commit();
    folder.write("O1001.nc", bad);
    folder.write("O2.nc", bad);
    const Finished finished = shell("$maclint --format concise --select MAC301 --since HEAD");
    EXPECT_EQ(finished.err,
              "maclint: note: all lines of 'O1001.nc' and 1 other count as changed: git holds a "
              "pointer to a large file in their place.\n");
    EXPECT_THAT(finished.out, AllOf(HasSubstr("O1001.nc:3:1:"), HasSubstr("O2.nc:3:1:")));
    EXPECT_EQ(finished.status, 1);
}

TEST_F(Since, AnOldTextOutOfAllProportionIsNotRead) {
    folder.write("O1001.nc", std::string(bad) + std::string(3'000'000, '\n'));
    commit();
    folder.write("O1001.nc", bad);
    EXPECT_EQ(found("--since HEAD"), "O1001.nc:3:1:\n1");
}

TEST_F(Since, TakesAllNamesOfARevision) {
    ASSERT_EQ(shell("git tag old && git tag -a -m y annotated && git branch side && "
                    "git update-ref refs/remotes/origin/main HEAD")
                  .status,
              0);
    folder.write("O1001.nc", worse);
    ASSERT_EQ(shell("git commit -qam later").status, 0);
    for (const char* name :
         {"old", "annotated", "side", "origin/main", "HEAD~1", "HEAD^", "'HEAD@{1}'", "':/^x'",
          "'HEAD^{/^x}'", "@~1", "refs/tags/old", "$(git rev-parse --short=5 HEAD~1)"})
        EXPECT_EQ(found("--since " + std::string(name)), "O1001.nc:5:12:\n1") << name;
    EXPECT_EQ(found("--since ':/^later'"), "0");
    for (const char* name :
         {"HEAD:O1001.nc", "HEAD~2", "':/nowhere'", "$(git rev-parse HEAD | tr 0-9a-f 1-9a-f0)"})
        EXPECT_THAT(found("--since " + std::string(name)), HasSubstr("names no revision that git knows"))
            << name;
}

TEST_F(Since, WorksInAHookOfGit) {
    folder.write(".git/hooks/pre-commit",
                 "#!/bin/sh\nenv | grep -c ^GIT_ > \"$(git rev-parse --git-dir)/variables\"\n"
                 "$maclint --format concise --quiet --select MAC301,MAC559 --since HEAD > \"$found\"\n");
    folder.write("O1001.nc", worse);
    const std::string commit =
        "chmod +x .git/hooks/pre-commit; found=$PWD/.git/found; export maclint found; ";
    const std::string show = "sed 's/ .*//' $found; cat $(git rev-parse --git-dir)/variables";
    EXPECT_THAT(shell(commit + "git commit -qam x; echo $?; " + show).out, StartsWith("1\nO1001.nc:5:12:\n"));
    EXPECT_THAT(shell(commit +
                      "git worktree add -q --detach tree && cp O1001.nc tree && cd tree && "
                      "git commit -qam x; echo $?; " +
                      show)
                    .out,
                StartsWith("1\nO1001.nc:5:12:\n"));
}

TEST_F(Since, WorksInASubmoduleAndWithOtherHashes) {
    const std::string check =
        "$maclint --format concise --quiet --select MAC301,MAC559 --since HEAD O1001.nc | "
        "sed 's/ .*//'";
    const Finished submodule =
        shell("git init -q outer && cd outer && "
              "git -c protocol.file.allow=always submodule --quiet add \"${PWD%/*}\" sub && cd sub && "
              "test -f .git && echo 'G1 X1. F9. F8.' > O1001.nc && " +
              check);
    EXPECT_EQ(submodule.out, "O1001.nc:1:12:\n") << submodule.err;
    const Finished other = shell("git init -q --object-format=sha256 sha && cp O1001.nc sha && cd sha && "
                                 "git add -A && git -c user.name=a -c user.email=b commit -qm x && "
                                 "sed 's/^M30/G1 X1. F9. F8./' ../O1001.nc > O1001.nc && " +
                                 check);
    EXPECT_EQ(other.out, "O1001.nc:5:12:\n") << other.err;
}

TEST_F(Since, ARepositoryOfAnotherOwnerIsNotTrusted) {
    if (::geteuid() != 0) GTEST_SKIP() << "only root can give files away";
    const Finished finished = shell("chown -R 12345 . && $maclint --since HEAD");
    EXPECT_EQ(finished.status, 2);
    EXPECT_EQ(finished.out, "");
    EXPECT_THAT(finished.err, AllOf(HasSubstr("it says 'fatal: detected dubious ownership in repository at"),
                                    HasSubstr("safe.directory")));
    EXPECT_EQ(shell("printf '[safe]\\ndirectory = *\\n' > .git/own; GIT_CONFIG_GLOBAL=$PWD/.git/own "
                    "$maclint --quiet --since HEAD")
                  .status,
              0);
}

TEST_F(Since, CountsAProgramOfAFolderThatGitDoesNotTellOfAsUnchangedAndSaysSo) {
    folder.write("O9001.nc", "%\nO9001\n#2=10/#7\nG0 X#2\nM99\n%\n");
    folder.write("other/O1.nc", "%\nO1\nG65 P9001 A1.\nM30\n%\n");
    commit();
    fs::create_directory(folder.path() / "other/.git");
    const Finished finished = shell("$maclint --format concise --select MAC210 --since HEAD O9001.nc");
    EXPECT_EQ(finished.status, 0);
    EXPECT_THAT(finished.err, AllOf(HasSubstr("other' count as unchanged."), HasSubstr("fatal: not a git")));
}

TEST_F(Since, LineEndsAreNoChange) {
    ASSERT_EQ(shell("sed -i 's/$/\\r/' O1001.nc && grep -q \"$(printf '99\\r')\" O1001.nc").status, 0);
    EXPECT_EQ(found("--since HEAD"), "0");
}

TEST_F(Since, CountsLinesAsGitDoes) {
    folder.write("O1001.nc", "%\rO1001\rGOTO 99\rM30\r%\r\nGOTO 97\r\n"); // two lines for git
    commit();
    folder.write("O1001.nc", "%\rO1001\rGOTO 99\rM30\r%\r\nGOTO 96\r\n");
    EXPECT_EQ(found("--since HEAD"), "0");
    folder.write("O1001.nc", "%\rO1001\rGOTO 98\rM30\r%\r\nGOTO 97\r\n");
    EXPECT_EQ(found("--since HEAD"), "O1001.nc:3:1:\n1");
}

TEST_F(Since, TakesNamesOfAllKinds) {
    for (const char* name : {"W\xC3\xBCrfel Gr\xC3\xB6\xC3\x9F\x65.nc", "it's \"5%\" b.nc", "two\nlines.nc",
                             "w\xFCrfel.nc", "tab\tback\\slash.nc", "a b.nc"})
        folder.write(name, bad);
    commit();
    EXPECT_EQ(found("--since HEAD"), "0");
    for (const auto& entry : fs::directory_iterator(folder.path()))
        if (entry.path().extension() == ".nc") folder.write(entry.path().filename().string(), worse);
    const std::string all = found("--since HEAD");
    EXPECT_EQ(std::ranges::count(all, '\n'), 7) << all;
    EXPECT_THAT(all, Not(HasSubstr(":3:1:")));
}

TEST_F(Since, APathThroughAChangedLineCounts) {
    folder.write("O1001.nc",
                 "%\nO1001\nIF[#100EQ1]GOTO20\nWHILE[#1LT5]DO1\nN20 G0 X#1\n#1=#1+1\nEND1\nM30\n%\n");
    commit();
    EXPECT_EQ(found("--since HEAD"), "0");
    folder.write("O1001.nc",
                 "%\nO1001\nIF[#100EQ1]GOTO20\nWHILE[#1LT7]DO1\nN20 G0 X#1\n#1=#1+1\nEND1\nM30\n%\n");
    EXPECT_EQ(found("--since HEAD"), "O1001.nc:3:12:\n1");
}

TEST_F(Since, WorksFromBelowAndWithSettingsOfTheUser) {
    folder.write("mill/O2.nc", bad);
    commit();
    folder.write("mill/O2.nc", worse);
    EXPECT_EQ(
        shell(
            "for s in diff.noprefix diff.mnemonicPrefix diff.relative color.ui; do git config $s true; done; "
            "git config diff.external false; git config diff.interHunkContext 50; git config color.ui "
            "always; "
            "cd mill && $maclint --format concise --quiet --since HEAD . ../O1001.nc | sed 's/ .*//'")
            .out,
        "O2.nc:5:12:\n");
}

TEST_F(Since, AllOfStandardInputHasChanged) {
    EXPECT_EQ(found("--since HEAD - --stdin-filename O1001.nc", std::string(bad)), "O1001.nc:3:1:\n1");
}

TEST_F(Since, ConflictsHaveChanged) {
    ASSERT_EQ(shell("git checkout -q -b one; sed -i s/99/91/ O1001.nc; git commit -qam 1; git checkout -q -; "
                    "sed -i s/99/92/ O1001.nc; git commit -qam 2; git merge one > /dev/null; test $? = 1")
                  .status,
              0);
    EXPECT_EQ(found("--since HEAD"), "O1001.nc:4:1:\n1"); // the mark before it is line 3
}

TEST_F(Since, ACallerInAnotherRepositoryCountsWhereGitKnowsTheRevisionThere) {
    folder.write("O9001.nc", "%\nO9001\n#2=10/#7\nG0 X#2\nM99\n%\n");
    folder.write("other/O1.nc", "%\nO1\nG65 P9001 A1.\nM30\n%\n");
    ASSERT_EQ(shell("cd other && git init -q . && git config user.name a && git config user.email b && "
                    "git add -A && git commit -q -m other")
                  .status,
              0);
    commit();
    const std::string callee = " --select MAC210 O9001.nc";
    EXPECT_EQ(found(callee), "O9001.nc:3:7:\n1");
    EXPECT_EQ(found("--since HEAD" + callee), "0");
    EXPECT_EQ(found("--since $(git rev-parse HEAD)" + callee), "0");
    folder.write("other/O1.nc", "%\nO1\nG65 P9001 A2.\nM30\n%\n");
    EXPECT_EQ(found("--since HEAD" + callee), "O9001.nc:3:7:\n1");
    EXPECT_EQ(found("--since $(git rev-parse HEAD)" + callee), "0");
    ASSERT_EQ(shell("git -C other mv -f O1.nc O3.nc && git -C other commit -qam moved").status, 0);
    EXPECT_EQ(found("--since HEAD" + callee), "0");
    ASSERT_EQ(shell("git -C other rm -q --cached O3.nc && git -C other commit -qm left").status, 0);
    EXPECT_EQ(found("--since HEAD" + callee), "O9001.nc:3:7:\n1"); // git does not know it
}

TEST_F(Since, KnowsABaselineToo) {
    folder.write("O1001.nc", worse);
    ASSERT_EQ(shell("$maclint --write-baseline base.json").status, 0);
    const Finished finished = shell("$maclint --baseline base.json --since HEAD");
    EXPECT_EQ(finished.status, 0);
    EXPECT_EQ(finished.err, "");
    EXPECT_EQ(finished.out, "no new findings (1 checked)\n1 known finding of base.json not shown\n");
}

TEST_F(Since, WhatHangsOnTheWholeFileCountsByAnyLine) {
    std::string noise;
    for (int i = 0; i < 4000; ++i) noise += static_cast<char>(i * 37 % 256);
    std::string program;
    for (int i = 0; i < 100; ++i) program += "G0 X" + std::to_string(i) + ".\n";
    const std::string foreign = "O100\n#1=R_SKIP[1]\nIF[#1EQ0]GOTO9\nALARM(\"NO TOUCH\")\n"
                                "W_G53G59_COOR[1,1]=#1\nGOTO7\nN9M99\n";
    folder.write("a.nc", program);
    folder.write("b.nc", foreign);
    commit();
    const auto found_in = [&](const std::string& file) {
        return shell("$maclint --since HEAD --quiet --format concise " + file);
    };
    EXPECT_EQ(found_in("b.nc").out, "");
    folder.write("a.nc", program + noise);
    folder.write("b.nc", foreign + "G0 X1.\n");
    EXPECT_THAT(found_in("a.nc").out, StartsWith("a.nc:1:1: error[MAC003]"));
    EXPECT_EQ(found_in("a.nc").status, 1);
    EXPECT_THAT(found_in("b.nc").out, AllOf(StartsWith("b.nc:2:"), HasSubstr("[MAC005]")));
    commit();
    EXPECT_EQ(found_in("a.nc").status, 0);
    EXPECT_EQ(found_in("b.nc").status, 0);
}

TEST_F(Since, RunsNoGitOfAnyFolderThatIsChecked) {
    folder.write("O1001.nc", worse);
    ASSERT_EQ(shell("mkdir bin && ln -s \"$(command -v git)\" bin/git && git init -q other && cd other && "
                    "cp ../O1001.nc . && git config user.name a && git config user.email a && git add -A && "
                    "git commit -q -m x && mkdir bin && "
                    "printf '#!/bin/sh\\ntouch %s/ran\\n' \"$PWD\" > bin/git && chmod +x bin/git")
                  .status,
              0);
    const Finished none = shell("PATH=$PWD/bin $maclint --since HEAD O1001.nc");
    EXPECT_EQ(none.status, 2);
    EXPECT_THAT(none.err, AllOf(HasSubstr("--since does not run '"), HasSubstr("/bin/git', which a folder"),
                                Not(HasSubstr("Install"))));
    EXPECT_EQ(found("O1001.nc other/O1001.nc --since HEAD"), "O1001.nc:5:12:\n1");
    ASSERT_EQ(shell("export PATH=$PWD/other/bin:$PATH; $maclint --since HEAD O1001.nc other/O1001.nc").status,
              1);
    EXPECT_FALSE(fs::exists(folder.path() / "other/ran"));
}

/// git is told to work in the repository's folder, and would look there.
TEST_F(Since, FindsTheUsersOwnFilesFromTheUsersFolder) {
    folder.write("user.cfg", "[[");
    folder.write(".gitconfig", "[[");
    folder.write("below/user.cfg", "");
    folder.write("O1001.nc", worse);
    for (const char* name : {"GIT_CONFIG_GLOBAL=user.cfg", "GIT_CONFIG_SYSTEM=user.cfg", "HOME=."})
        EXPECT_EQ(shell("cd below && env -u GIT_CONFIG_NOSYSTEM " + std::string(name) +
                        " $maclint --since HEAD --quiet ../O1001.nc")
                      .status,
                  1)
            << name;
}

TEST_F(Since, OfAPartialCloneOnlyTheFilesThatItLacksCountWhole) {
    for (const char* name : {"O1.nc", "O2.nc", "O3.nc", "O4.nc"})
        folder.write(name, std::string(bad) + "(" + name + ")\n");
    commit();
    ASSERT_EQ(shell("git config core.repositoryFormatVersion 1; git config extensions.partialClone x; "
                    "git config remote.x.promisor true; git config remote.x.url ../nowhere; "
                    "cp -r .git/objects .git/whole")
                  .status,
              0);
    // Whichever come first in the order in which git is asked.
    for (const auto& [first, second] : {std::pair("O2.nc", "O4.nc"), std::pair("O1.nc", "O3.nc")}) {
        const std::string lacking = std::string(first) + " " + second;
        ASSERT_EQ(shell("rm -rf .git/objects; cp -r .git/whole .git/objects; for f in " + lacking +
                        "; do blob=$(git rev-parse HEAD:$f); "
                        "rm -f .git/objects/$(echo $blob | cut -c1-2)/$(echo $blob | cut -c3-); done")
                      .status,
                  0);
        const Finished finished =
            shell("$maclint --format concise --quiet --select MAC301 --since HEAD | sed 's/ .*//'");
        EXPECT_EQ(finished.out, std::string(first) + ":3:1:\n" + second + ":3:1:\n");
        EXPECT_THAT(finished.err,
                    AllOf(HasSubstr(std::string("--since lacks '") + first + "' and 1 other as of 'HEAD'"),
                          Not(HasSubstr("Mend"))));
    }
}

TEST_F(Since, TooManyLinesToFindWhatWasRenamedAreSaid) {
    folder.write("O2.nc", std::string(bad) + std::string(2'100'000, '\n'));
    commit();
    ASSERT_EQ(shell("mv O2.nc O3.nc").status, 0);
    const Finished finished = shell("$maclint --since HEAD --select MAC301 O3.nc");
    EXPECT_THAT(finished.err, HasSubstr("too much is gone since 'HEAD'"));
    EXPECT_EQ(finished.status, 1);
}

/// Nothing is looked up outside, not even whether it is there.
TEST_F(Since, ANameThatLeadsOutOfTheFolderIsNotGone) {
    ASSERT_EQ(shell("blob=$(git rev-parse HEAD:O1001.nc); "
                    "tree=$(printf '100644 blob %s\\tgone.nc\\n' $blob | git mktree); "
                    "tree=$(printf '040000 tree %s\\t..\\n' $tree | git mktree); "
                    "git tag odd $(git commit-tree -m x $tree)")
                  .status,
              0);
    ASSERT_THAT(shell("git ls-tree -r --name-only odd").out, HasSubstr("../gone.nc"));
    EXPECT_EQ(found("--since odd O1001.nc"), "O1001.nc:3:1:\n1");
}

TEST_F(Since, SaysWhatIsMissing) {
    const auto refused = [&](const std::string& script, const std::string& message) {
        const Finished finished = shell(script);
        EXPECT_EQ(finished.status, 2) << script;
        EXPECT_THAT(finished.out, IsEmpty()) << script;
        EXPECT_THAT(finished.err, AllOf(StartsWith("maclint: error: "), HasSubstr(message))) << script;
    };
    refused("$maclint --since nowhere", "--since names no revision that git knows");
    for (const char* revision : {"^HEAD", "@{u}", "HEAD^{tree}", "HEAD..HEAD"})
        refused("$maclint --since '" + std::string(revision) + "'", "--since names no ");
    refused("$maclint --since '^HEAD'", "--since names no commit in '");
    refused("$maclint --since ''", "--since has an empty value");
    refused("$maclint --since --output=x", "--since wants a git revision");
    refused("PATH=/nowhere $maclint --since HEAD", "no git is found here");
    refused("rm -rf .git; mkdir .git; $maclint --since HEAD", "it says 'fatal: ");
    refused("rm -rf .git; $maclint --since HEAD", "'O1001.nc' lies in none");
}

} // namespace
} // namespace maclint::test
