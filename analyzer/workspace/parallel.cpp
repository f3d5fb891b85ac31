//! A crew of threads that take the next piece of work until none is left.
#include "analyzer/workspace/parallel.hpp"

#include "analyzer/source/platform/kept_by_thread.hpp"
#include "analyzer/source/platform/threads.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <vector>

namespace maclint {

void for_each_parallel(std::size_t count, unsigned jobs, const std::function<void(std::size_t)>& work) {
    const auto threads = std::min<std::size_t>(jobs, count);
    std::atomic<std::size_t> next{0};
    std::once_flag failed;
    std::exception_ptr failure;
    const auto take = [&] {
        try {
            for (std::size_t i = next++; i < count; i = next++) work(i);
        } catch (...) {
            next = count;
            std::call_once(failed, [&] { failure = std::current_exception(); });
        }
    };
    {
        // Nobody begins before all have been started: they would take the memory that others start with.
        std::atomic<bool> begun{false};
        std::vector<platform::Thread> crew;
        crew.reserve(threads);
        for (std::size_t i = 1; i < threads; ++i) {
            auto thread = platform::Thread::start([&] {
                const platform::ThreadWork with_what_it_keeps;
                begun.wait(false);
                take();
            });
            if (!thread) break; // the system gives no more: those that run do the work
            crew.push_back(*std::move(thread));
        }
        begun = true;
        begun.notify_all();
        take();
    }
    if (failure) std::rethrow_exception(failure);
}

} // namespace maclint
