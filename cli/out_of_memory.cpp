//! Takes no memory itself.
#include "cli/out_of_memory.hpp"

#include "analyzer/source/platform/output.hpp"
#include "analyzer/syntax/tree.hpp"
#include "cli/terminal.hpp"

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <thread>

namespace maclint::cli {
namespace {

[[noreturn]] void end_with(const char* line) noexcept {
    static std::atomic_flag ends;
    // Another thread is about to end all of them.
    while (ends.test_and_set()) std::this_thread::sleep_for(std::chrono::seconds(1));
    platform::remove_unfinished();
    std::fputs(line, stderr);
    std::_Exit(exit_error); // what standard output holds back is part of a report
}

/// An exception has left what must not throw.
[[noreturn]] void end_by_exception() noexcept {
    try {
        if (const auto exception = std::current_exception()) std::rethrow_exception(exception);
    } catch (const std::bad_alloc&) {
        end_out_of_memory();
    } catch (...) {
    }
    end_with("maclint: error: something went wrong inside maclint. Please report it.\n");
}

} // namespace

void end_out_of_memory() noexcept {
    end_with("maclint: error: there is not enough memory. Lint fewer files at a time.\n");
}

void end_run_without_memory() {
    syntax::set_out_of_memory(&end_out_of_memory);
    std::set_terminate(&end_by_exception);
}

} // namespace maclint::cli
