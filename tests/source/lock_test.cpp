//! Locks on files that are written, between processes.
#include "analyzer/source/platform/lock.hpp"
#include "tests/support/folder.hpp"

#include <cerrno>
#include <filesystem>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace maclint::platform {
namespace {

namespace fs = std::filesystem;

int count_one_more(const test::TemporaryFolder& folder, const std::string& path) {
    const WriteLock lock(path);
    const int count = std::stoi(test::read_file(path));
    ::usleep(5000); // time for others to read the same
    static_cast<void>(folder.write("count", std::to_string(count + 1)));
    return lock.error();
}

TEST(WriteLock, LetsOneProcessAfterTheOtherDoItsWork) {
    const test::TemporaryFolder folder;
    const std::string path = folder.write("count", "0");
    constexpr int processes = 16;
    for (int i = 0; i < processes; ++i) {
        if (::fork() != 0) continue;
        ::_exit(count_one_more(folder, path));
    }
    for (int i = 0; i < processes; ++i) {
        int status = 0;
        ::wait(&status);
        EXPECT_EQ(status, 0);
    }
    EXPECT_EQ(test::read_file(path), std::to_string(processes));
    EXPECT_FALSE(fs::exists(lock_name(path)));
}

TEST(WriteLock, EndsWithTheProcessThatHeldIt) {
    const test::TemporaryFolder folder;
    const std::string path = folder.write("file", "");
    const pid_t child = ::fork();
    if (child == 0) {
        const WriteLock lock(path);
        ::_exit(lock.error()); // as a signal does: nothing is cleared up
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
    EXPECT_TRUE(fs::exists(lock_name(path)));
    const auto begun = std::chrono::steady_clock::now();
    const WriteLock lock(path);
    EXPECT_EQ(lock.error(), 0);
    EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(5));
}

TEST(WriteLock, TellsWhyItCannotBeHad) {
    const test::TemporaryFolder folder;
    EXPECT_EQ(WriteLock((folder.path() / "gone/file").string()).error(), ENOENT);
    folder.write("full.lock", "somebody's own");
    EXPECT_EQ(WriteLock((folder.path() / "full").string()).error(), EEXIST);
    fs::create_symlink("elsewhere", folder.path() / "link.lock");
    EXPECT_EQ(WriteLock((folder.path() / "link").string()).error(), EEXIST);
    EXPECT_FALSE(fs::exists(folder.path() / "elsewhere"));
    EXPECT_EQ(test::read_file(folder.path() / "full.lock"), "somebody's own");
}

} // namespace
} // namespace maclint::platform
