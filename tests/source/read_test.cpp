//! Reading from disk: what is read byte for byte, and what is refused with words that help.
#include "analyzer/source/platform/input.hpp"
#include "analyzer/source/read.hpp"
#include "analyzer/source/source.hpp"

#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

namespace maclint {
namespace {

using namespace std::string_literals;
using testing::HasSubstr;

/// An empty folder for one test.
class ReadFile : public testing::Test {
  protected:
    ReadFile()
        : folder_(std::filesystem::path(testing::TempDir()) /
                  ("maclint-read-" + std::to_string(::getpid()))) {
        std::filesystem::create_directories(folder_);
    }
    ~ReadFile() override { std::filesystem::remove_all(folder_); }

    [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
    [[nodiscard]] std::string write(const std::string& name, const std::string& bytes) const {
        std::ofstream(path(name), std::ios::binary) << bytes;
        return path(name);
    }

  private:
    std::filesystem::path folder_;
};

std::string message_of(const std::string& path) {
    const auto result = Source::read_file(path);
    const auto* const error = std::get_if<InputError>(&result);
    return error == nullptr ? "was read" : error->message;
}

TEST_F(ReadFile, GivesTheBytesAndThePathAsTheyAre) {
    const std::string bytes = "\0%\r\nO1\n\xD8\r"s;
    const std::string path = write("O1.nc", bytes);
    const auto result = Source::read_file(path);
    ASSERT_TRUE(std::holds_alternative<Source>(result));
    EXPECT_EQ(std::get<Source>(result).bytes(), bytes);
    EXPECT_EQ(std::get<Source>(result).path(), path);
}

TEST_F(ReadFile, ReadsAnEmptyFile) {
    const auto result = Source::read_file(write("empty.nc", ""));
    ASSERT_TRUE(std::holds_alternative<Source>(result));
    EXPECT_EQ(std::get<Source>(result).size(), 0U);
}

TEST_F(ReadFile, ReadsAPipeToItsEnd) {
    if (!std::filesystem::exists("/dev/fd")) GTEST_SKIP() << "this system does not name open files";
    std::array<int, 2> ends{};
    ASSERT_EQ(::pipe(ends.data()), 0);
    const std::string text(60'000, 'X'); // fits a pipe, so nobody has to read yet
    ASSERT_EQ(::write(ends[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
    ::close(ends[1]);
    const auto result = Source::read_file("/dev/fd/" + std::to_string(ends[0]));
    ::close(ends[0]);
    ASSERT_TRUE(std::holds_alternative<Source>(result));
    EXPECT_EQ(std::get<Source>(result).bytes(), text);
}

TEST_F(ReadFile, DoesNotWaitForEverForAPipeThatNobodyWritesTo) {
    const std::string pipe = path("pipe");
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_THAT(message_of(pipe), HasSubstr("nothing has come through this pipe for 10 seconds."));
}

TEST_F(ReadFile, DoesNotWaitForEverForAFileOfTheKernel) {
    if (::access("/proc/kmsg", R_OK) != 0) GTEST_SKIP() << "only the superuser may read it";
    EXPECT_THAT(message_of("/proc/kmsg"), HasSubstr("the system has given nothing of it for 10 seconds."));
}

TEST_F(ReadFile, ReadsFilesOfTheKernelThatEnd) {
    if (!std::filesystem::exists("/proc/self/status")) GTEST_SKIP() << "this system has no such files";
    EXPECT_EQ(message_of("/proc/self/status"), "was read");
}

TEST_F(ReadFile, RefusesAFileLargerThanTheLimitBeforeItIsRead) {
    const std::string large = write("large.nc", "M30");
    std::error_code error;
    std::filesystem::resize_file(large, (std::uintmax_t{1} << 32U) - 10, error); // takes no disk space
    if (error) GTEST_SKIP() << "the file system has no sparse files";
    const auto begin = std::chrono::steady_clock::now();
    const auto result = maclint::read_file(large, {std::uintmax_t{1} << 30U, "Leave it out."});
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(500));
    ASSERT_TRUE(std::holds_alternative<InputError>(result));
    EXPECT_THAT(std::get<InputError>(result).message, HasSubstr("it is larger than 1 GiB. Leave it out."));
}

TEST_F(ReadFile, TakesAFileOfTheLimitAndNoByteMore) {
    const auto read = [&](const std::string& bytes, std::uintmax_t limit) {
        const auto result = maclint::read_file(write("O1.nc", bytes), {limit, "Cut it."});
        const auto* const error = std::get_if<InputError>(&result);
        return error == nullptr ? "was read" : error->message.substr(error->message.find(": ") + 2);
    };
    EXPECT_EQ(read("12345", 5), "was read");
    EXPECT_EQ(read("123456", 5), "it is larger than 5 bytes. Cut it.");
    EXPECT_EQ(read("12", 1), "it is larger than 1 byte. Cut it.");
    EXPECT_EQ(read(std::string(3 * 1024 + 1, 'X'), 3 * 1024), "it is larger than 3 KiB. Cut it.");
}

TEST_F(ReadFile, StopsAtTheLimitOfWhatHasNoSizeBefore) {
    if (!std::filesystem::exists("/proc/self/status")) GTEST_SKIP() << "this system has no such files";
    const auto result = maclint::read_file("/proc/self/status", {100, "Cut it."});
    ASSERT_TRUE(std::holds_alternative<InputError>(result));
    EXPECT_THAT(std::get<InputError>(result).message, HasSubstr("it is larger than 100 bytes."));
}

TEST_F(ReadFile, RefusesASocket) {
    const std::string name = path("s");
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    ASSERT_LT(name.size(), sizeof address.sun_path);
    name.copy(address.sun_path, name.size());
    const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
    ASSERT_EQ(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    EXPECT_THAT(message_of(name), HasSubstr("it is a device or a socket"));
    ::close(socket);
}

TEST(PipeWait, EndsWithBytesWithTheEndOrAfterTheTime) {
    using namespace std::chrono_literals;
    std::array<int, 2> ends{};
    ASSERT_EQ(::pipe(ends.data()), 0);
    EXPECT_FALSE(platform::comes_in_time(ends[0], 20ms));
    std::jthread writer([&] {
        std::this_thread::sleep_for(30ms);
        EXPECT_EQ(::write(ends[1], "%", 1), 1);
    });
    EXPECT_TRUE(platform::comes_in_time(ends[0], 20s));
    writer.join();
    char byte = 0;
    EXPECT_EQ(::read(ends[0], &byte, 1), 1);
    ::close(ends[1]);
    EXPECT_TRUE(platform::comes_in_time(ends[0], 20s));
    ::close(ends[0]);
}

TEST_F(ReadFile, SaysThatAFileIsMissing) {
    EXPECT_THAT(message_of(path("gone.nc")), HasSubstr("gone.nc' cannot be read: there is no such file"));
}

TEST_F(ReadFile, RefusesAFolder) { EXPECT_THAT(message_of(path("")), HasSubstr("it is a folder")); }

TEST_F(ReadFile, RefusesADevice) { EXPECT_THAT(message_of("/dev/zero"), HasSubstr("it is a device")); }

TEST_F(ReadFile, SaysThatPermissionIsMissing) {
    if (::geteuid() == 0) GTEST_SKIP() << "the superuser may read every file";
    const std::string locked = write("locked.nc", "M30");
    std::filesystem::permissions(locked, std::filesystem::perms::none);
    EXPECT_THAT(message_of(locked), HasSubstr("you have no permission"));
}

TEST_F(ReadFile, RefusesFourGibibytes) {
    const std::string large = write("large.nc", "");
    std::error_code error;
    std::filesystem::resize_file(large, std::uintmax_t{1} << 32U, error); // takes no disk space
    if (error) GTEST_SKIP() << "the file system has no sparse files";
    EXPECT_THAT(message_of(large), HasSubstr("4 GiB or more"));
}

TEST_F(ReadFile, NamesAHostilePathWithoutItsControlCharacters) {
    EXPECT_THAT(message_of(path("a\x1B[2Jb")), HasSubstr("a\\x1B[2Jb"));
}

TEST(SourceCopies, ShareBytesThatStayInPlace) {
    auto original = std::make_unique<Source>(Source::from_bytes("O1.nc", "M30"));
    const std::string_view view = original->bytes();
    const Source copy = *original;
    original.reset();
    EXPECT_EQ(copy.bytes().data(), view.data());
    EXPECT_EQ(copy.to_utf8(view), "M30");
}

TEST(SourceCopies, MayBeAskedForPositionsByManyThreads) {
    const Source source = Source::from_bytes("O1.nc", std::string(100'000, '\n'));
    std::vector<std::thread> threads;
    threads.reserve(8);
    for (int count = 0; count < 8; ++count) {
        threads.emplace_back([copy = source] { EXPECT_EQ(copy.position(99'999).line, 100'000U); });
    }
    for (std::thread& thread : threads) thread.join();
}

} // namespace
} // namespace maclint
