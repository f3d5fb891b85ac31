//! Files are written whole or not at all.
#include "cli/terminal.hpp"
#include "tests/support/folder.hpp"

#include <csignal>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace maclint::cli {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using testing::ElementsAre;

std::vector<std::string> names_in(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
    return names;
}

/// No file of this process grows beyond `bytes` while this lives: a full disk.
class FullDisk {
  public:
    explicit FullDisk(rlim_t bytes) {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
        handler_ = std::signal(SIGXFSZ, SIG_IGN); // NOLINT(performance-no-int-to-ptr)
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;
    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }

  private:
    rlimit before_{};
    void (*handler_)(int) = nullptr;
};

TEST(WrittenFiles, KeepTheirOldTextWhenTheNewOneCannotBeWritten) {
    const TemporaryFolder folder;
    const std::string path = folder.write("report.json", "old");
    std::optional<Notice> failure;
    {
        const FullDisk disk(1000);
        failure = write_to(path, std::string(100'000, 'x'));
    }
    ASSERT_TRUE(failure);
    EXPECT_THAT(failure->message, testing::HasSubstr("it would be larger than the system allows"));
    EXPECT_EQ(test::read_file(path), "old");
    EXPECT_THAT(names_in(folder.path()), ElementsAre("report.json")) << "nothing is left after";
}

TEST(WrittenFiles, ComeWhereALinkLeadsThoughNothingIsThereYet) {
    const TemporaryFolder folder;
    const fs::path link = folder.path() / "link";
    fs::create_symlink("report.json", link);
    EXPECT_FALSE(write_to(link.string(), "new"));
    EXPECT_TRUE(fs::is_symlink(link));
    EXPECT_EQ(test::read_file(folder.path() / "report.json"), "new");
}

TEST(WrittenFiles, AreNotLeftHalfDoneByAnInterrupt) {
    const TemporaryFolder folder;
    const std::string path = folder.write("report.json", "old");
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU}) {
        const std::string text(std::size_t{200} << 20U, 'x');
        const pid_t child = fork();
        if (child == 0) _exit(write_to(path, text) ? 1 : 0);
        while (names_in(folder.path()).size() < 2 && waitpid(child, nullptr, WNOHANG) == 0) {
        }
        kill(child, signal);
        int status = 0;
        if (waitpid(child, &status, 0) != child || WIFEXITED(status))
            GTEST_SKIP() << "it was written too fast";
        EXPECT_EQ(WTERMSIG(status), signal);
        EXPECT_THAT(names_in(folder.path()), ElementsAre("report.json")) << "nothing is left after";
        EXPECT_EQ(test::read_file(path), "old");
    }
}

TEST(WrittenFiles, KeepTheirRightsAndTheLinksThatLeadToThem) {
    const TemporaryFolder folder;
    const std::string path = folder.write("report.json", "old");
    fs::permissions(path, fs::perms{0640});
    const fs::path link = folder.path() / "link.json";
    fs::create_symlink("report.json", link);
    EXPECT_FALSE(write_to(link.string(), "new"));
    EXPECT_TRUE(fs::is_symlink(link));
    EXPECT_EQ(test::read_file(path), "new");
    EXPECT_EQ(fs::status(path).permissions(), fs::perms{0640});
}

TEST(WrittenFiles, MayBeNewOrNoFilesAtAll) {
    const TemporaryFolder folder;
    const std::string path = (folder.path() / "new.json").string();
    EXPECT_FALSE(write_to(path, "text"));
    EXPECT_EQ(test::read_file(path), "text");
    EXPECT_EQ(fs::status(path).permissions() & fs::perms::owner_all,
              fs::perms::owner_read | fs::perms::owner_write);
    EXPECT_FALSE(write_to("/dev/null", "text"));
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

} // namespace
} // namespace maclint::cli
