//! How a run ends that gets no memory where no exception may be thrown.
#include "analyzer/dialect/fanuc/kinds.hpp"
#include "analyzer/source/platform/output.hpp"
#include "analyzer/syntax/tree.hpp"
#include "cli/out_of_memory.hpp"
#include "tests/support/folder.hpp"
#include "tests/support/lines.hpp"
#include "tests/support/sanitized.hpp"

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <new>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

namespace maclint::cli {
namespace {

namespace fs = std::filesystem;
using testing::ExitedWithCode;

constexpr const char* no_memory =
    "^maclint: error: there is not enough memory. Lint fewer files at a time.\n$";

/// The system gives this process no more, and nothing is left of what it has.
void use_up_memory() {
    const rlimit none{.rlim_cur = 1, .rlim_max = RLIM_INFINITY};
    setrlimit(RLIMIT_AS, &none);
    for (std::size_t size = std::size_t{1} << 30U; size >= 16; size /= 2)
        // NOLINTNEXTLINE(cppcoreguidelines-no-malloc): as tree-sitter does
        while (void* volatile lost = std::malloc(size)) static_cast<void>(lost);
}

TEST(OutOfMemoryDeathTest, InTheParserEndsTheRunWithOneLine) {
    if (test::sanitized()) GTEST_SKIP() << "a sanitizer takes more memory than may be given";
    const std::string block = test::copies_of("X[#1+2]", 500);
    const auto parse_without_memory = [&] {
        end_run_without_memory();
        syntax::Tree tree;
        syntax::parse(fanuc::grammar, "G0", tree);
        use_up_memory();
        syntax::parse(fanuc::grammar, block, tree);
    };
    EXPECT_EXIT(parse_without_memory(), ExitedWithCode(2), no_memory);
}

TEST(OutOfMemoryDeathTest, InWhatMustNotThrowEndsTheRunWithOneLine) {
    const auto throw_out_of = [](const std::function<void()>& what) noexcept { what(); };
    const auto run = [&](const std::function<void()>& what) {
        end_run_without_memory();
        throw_out_of(what);
    };
    EXPECT_EXIT(run([] { throw std::bad_alloc(); }), ExitedWithCode(2), no_memory);
    EXPECT_EXIT(run([] { throw 1; }), ExitedWithCode(2), "^maclint: error: something went wrong");
}

TEST(OutOfMemoryDeathTest, LeavesTheOldReportAndNoPartOfTheNewOne) {
    const test::TemporaryFolder folder;
    const std::string path = folder.write("report.json", "old");
    const std::string report(std::size_t{1} << 27U, 'r');
    const auto count = [&] {
        return std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator());
    };
    const auto end_while_writing = [&] {
        std::thread([&] { static_cast<void>(platform::replace_file(path, report)); }).detach();
        while (count() == 1) std::this_thread::yield();
        end_out_of_memory();
    };
    EXPECT_EXIT(end_while_writing(), ExitedWithCode(2), no_memory);
    EXPECT_EQ(test::read_file(path), "old");
    EXPECT_EQ(count(), 1);
}

TEST(OutOfMemoryDeathTest, OnTwoThreadsIsSaidOnce) {
    const auto end_twice = [] {
        std::thread(&end_out_of_memory).detach();
        end_out_of_memory();
    };
    for (int i = 0; i < 20; ++i) EXPECT_EXIT(end_twice(), ExitedWithCode(2), no_memory);
}

} // namespace
} // namespace maclint::cli
