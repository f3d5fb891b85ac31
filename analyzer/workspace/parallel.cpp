//! A crew of threads that take the next piece of work until none is left.
#include "analyzer/workspace/parallel.hpp"

#include "analyzer/source/platform/kept_by_thread.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
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
        std::vector<std::jthread> crew;
        try {
            for (std::size_t i = 1; i < threads; ++i)
                crew.emplace_back([&] {
                    const platform::ThreadWork with_what_it_keeps;
                    take();
                });
        } catch (const std::system_error&) {
            // The system gives no more threads: those that run do the work.
        }
        take();
    }
    if (failure) std::rethrow_exception(failure);
}

} // namespace maclint
