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
std::string written_by(ProcessRequest request) {
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
        EXPECT_EQ(run_process({.words = {"maclint-here"}, .not_below = folder.path().string()}, ignore).by,
                  EndedBy::nothing_started);
        EXPECT_TRUE(
            run_process({.words = {"maclint-here"}, .not_below = folder.path().string() + "-not"}, ignore)
                .succeeded());
    }
}

} // namespace
} // namespace maclint::platform
