//! Other programs: what they get, what comes back, when they are ended.
#include "analyzer/source/platform/process.hpp"
#include "tests/support/folder.hpp"

#include <csignal>
#include <cstdlib>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::platform {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

bool ignore(std::string_view) { return true; }

/// What a script of the shell writes.
std::string written_by(const ProcessRequest& request) {
    std::string out;
    const auto end = run_process(request, [&](std::string_view part) {
        out += part;
        return true;
    });
    EXPECT_EQ(end.by, EndedBy::itself);
    return out;
}

TEST(Process, GivesOutputErrorsAndStatus) {
    std::string out;
    const auto end = run_process(
        {.words = {"sh", "-c", "printf '%s' \"$1\"; cat; echo no >&2; exit 3", "sh", "a 'b\" $c\n"}},
        [&](std::string_view part) {
            out += part;
            return true;
        });
    EXPECT_EQ(end.by, EndedBy::itself);
    EXPECT_EQ(end.status, 3);
    EXPECT_FALSE(end.succeeded());
    EXPECT_EQ(out, "a 'b\" $c\n");
    EXPECT_EQ(end.errors, "no\n");
}

TEST(Process, ReadsMoreThanPipesHold) {
    std::size_t size = 0;
    const auto end =
        run_process({.words = {"sh", "-c", "yes o | head -c 300000; yes e | head -c 300000 >&2; kill -9 $$"}},
                    [&](std::string_view part) {
                        size += part.size();
                        return true;
                    });
    EXPECT_EQ(size, 300'000U);
    EXPECT_EQ(end.errors.size(), 4096U);
    EXPECT_EQ(end.status, 137);
}

/// A program that writes while it reads waits for both ends.
TEST(Process, WritesMoreThanPipesHoldWhileItReads) {
    std::string input;
    for (int i = 0; i < 200'000; ++i) input += std::to_string(i) + "\n";
    EXPECT_EQ(written_by({.words = {"sh", "-c", "cat; echo end"}, .input = input}), input + "end\n");
}

TEST(Process, OutlivesAProgramThatReadsNothing) {
    const std::string input(1'000'000, 'x');
    const auto end = run_process({.words = {"sh", "-c", "exit 4"}, .input = input}, ignore);
    EXPECT_EQ(end.by, EndedBy::itself);
    EXPECT_EQ(end.status, 4);
    // A signal that is ignored here is not ignored there.
    EXPECT_EQ(run_process({.words = {"sh", "-c", "kill -PIPE $$"}}, ignore).status, 128 + SIGPIPE);
}

/// Services start programs that way; the system then keeps no exit status.
TEST(Process, GivesTheStatusThoughWhoStartedItIgnoresEnds) {
    auto* const before = std::signal(SIGCHLD, SIG_IGN);
    const auto end = run_process({.words = {"sh", "-c", "exit 3"}}, ignore);
    EXPECT_EQ(end.status, 3);
    EXPECT_EQ(std::signal(SIGCHLD, before), SIG_IGN);
}

TEST(Process, EndsWhatIsSilent) {
    using namespace std::chrono_literals;
    const auto end =
        run_process({.words = {"sh", "-c", "echo a; sleep 60; echo b"}, .patience = 300ms}, ignore);
    EXPECT_EQ(end.by, EndedBy::silence);
    EXPECT_EQ(end.status, 128 + SIGKILL);
    EXPECT_EQ(run_process(
                  {.words = {"sh", "-c", "for i in 1 2 3 4 5; do sleep 0.2; echo; done"}, .patience = 800ms},
                  ignore)
                  .by,
              EndedBy::itself);
}

TEST(Process, EndsWhatGoesOnForTooLong) {
    using namespace std::chrono_literals;
    const auto begin = std::chrono::steady_clock::now();
    const auto end = run_process(
        {.words = {"sh", "-c", "while :; do sleep 0.05; echo; done"}, .patience = 20s, .longest = 400ms},
        ignore);
    EXPECT_EQ(end.by, EndedBy::time);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 15s);
    EXPECT_EQ(run_process({.words = {"sh", "-c", "sleep 60"}, .longest = 100ms}, ignore).by, EndedBy::time);
}

TEST(Process, EndsWhatSaysMoreThanIsWanted) {
    EXPECT_EQ(run_process({.words = {"yes"}}, [](std::string_view) { return false; }).by, EndedBy::taker);
}

TEST(Process, TellsThatThereIsNoSuchProgram) {
    EXPECT_EQ(run_process({.words = {"maclint-no-such-program"}}, ignore).by, EndedBy::nothing_started);
}

class ProcessEnvironment : public testing::Test {
  protected:
    void SetUp() override { path_ = std::getenv("PATH"); }
    void TearDown() override { ::setenv("PATH", path_.c_str(), 1); }

    std::string path_;
};

TEST_F(ProcessEnvironment, ChangesAsItIsAskedTo) {
    ::setenv("MACLINT_ONE", "1", 1);
    ::setenv("MACLINT_TWO", "2", 1);
    ::setenv("MACLINT_THREE", "3", 1);
    const std::string all = written_by({.words = {"env"},
                                        .left_out_prefix = "MACLINT_",
                                        .kept = {"MACLINT_TWO"},
                                        .set = {"MACLINT_THREE=4", "MACLINT_FIVE="}});
    EXPECT_THAT(all, AllOf(Not(HasSubstr("MACLINT_ONE")), HasSubstr("MACLINT_TWO=2\n"),
                           HasSubstr("MACLINT_THREE=4\n"), Not(HasSubstr("MACLINT_THREE=3")),
                           HasSubstr("MACLINT_FIVE=\n"), HasSubstr("PATH=")));
    EXPECT_THAT(written_by({.words = {"env"}}), HasSubstr("MACLINT_ONE=1\n"));
}

/// The current folder is the one that is checked.
TEST_F(ProcessEnvironment, RunsNothingOfTheCurrentFolder) {
    const test::TemporaryFolder folder;
    const std::string program = folder.write("maclint-here", "#!/bin/sh\n");
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(folder.path());
    for (const char* path : {".", "", "/nowhere:", ":/nowhere", "./"}) {
        ::setenv("PATH", path, 1);
        EXPECT_EQ(run_process({.words = {"maclint-here"}}, ignore).by, EndedBy::nothing_started) << path;
    }
    std::filesystem::current_path(before);
    ::setenv("PATH", folder.path().c_str(), 1);
    EXPECT_TRUE(run_process({.words = {"maclint-here"}}, ignore).succeeded());
}

TEST_F(ProcessEnvironment, RunsNothingOfAFolderThatIsLeftOut) {
    const test::TemporaryFolder folder;
    const std::string program = folder.write("bin/maclint-here", "#!/bin/sh\n");
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    const test::TemporaryFolder other;
    std::filesystem::create_symlink(program, other.path() / "maclint-here");
    for (const auto& path : {folder.path() / "bin", other.path()}) {
        ::setenv("PATH", path.c_str(), 1);
        EXPECT_EQ(run_process({.words = {"maclint-here"}, .not_below = {folder.path().string()}}, ignore).by,
                  EndedBy::nothing_started);
        EXPECT_TRUE(
            run_process({.words = {"maclint-here"}, .not_below = {folder.path().string() + "-not"}}, ignore)
                .succeeded());
    }
}

/// A folder that is left out is known by any of the ways there.
TEST_F(ProcessEnvironment, RunsNothingThatTheWayLeadsToThroughAFolderThatIsLeftOut) {
    const test::TemporaryFolder folder;
    const test::TemporaryFolder other;
    const std::string program = other.write("bin/maclint-here", "#!/bin/sh\n");
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    std::filesystem::create_directory(folder.path() / "own");
    std::filesystem::create_symlink(program, folder.path() / "own/maclint-here");
    std::filesystem::create_directory_symlink(other.path() / "bin", folder.path() / "bin");
    std::filesystem::create_directory_symlink(folder.path() / "own", other.path() / "way");
    const ProcessRequest request{.words = {"maclint-here"},
                                 .not_below = {"/nowhere", folder.path().string()}};
    for (const auto& path : {folder.path() / "own", folder.path() / "bin", other.path() / "way",
                             other.path() / "bin/.." / ".." / folder.path().filename() / "bin"}) {
        ::setenv("PATH", path.c_str(), 1);
        const auto end = run_process(request, ignore);
        EXPECT_EQ(end.by, EndedBy::nothing_started) << path;
        EXPECT_EQ(end.passed_over, (path / "maclint-here").string());
        ::setenv("PATH", (path.string() + ":" + other.path().string() + "/bin").c_str(), 1);
        EXPECT_TRUE(run_process(request, ignore).succeeded()) << path;
    }
}

TEST_F(ProcessEnvironment, MakesPathsAbsolute) {
    ::setenv("MACLINT_ONE", "a/b", 1);
    ::setenv("MACLINT_TWO", "/c", 1);
    ::setenv("MACLINT_THREE", "", 1);
    ::setenv("MACLINT_FOUR", "a", 1);
    const std::string all = written_by({.words = {"env"},
                                        .left_out_prefix = "MACLINT_",
                                        .paths = {"MACLINT_ONE", "MACLINT_TWO", "MACLINT_THREE"}});
    const std::string here = std::filesystem::current_path().string();
    EXPECT_THAT(all, AllOf(HasSubstr("MACLINT_ONE=" + here + "/a/b\n"), HasSubstr("MACLINT_TWO=/c\n"),
                           HasSubstr("MACLINT_THREE=\n"), Not(HasSubstr("MACLINT_FOUR"))));
}

} // namespace
} // namespace maclint::platform
