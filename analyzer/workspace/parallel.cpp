//! A crew of threads that take the next piece of work until none is left.
#include "analyzer/workspace/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace maclint {

void for_each_parallel(std::size_t count, unsigned jobs, const std::function<void(std::size_t)>& work) {
    const auto threads = std::min<std::size_t>(jobs, count);
    std::atomic<std::size_t> next{0};
    const auto take = [&] {
        for (std::size_t i = next++; i < count; i = next++) work(i);
    };
    std::vector<std::jthread> crew;
    for (std::size_t i = 1; i < threads; ++i) crew.emplace_back(take);
    take();
}

} // namespace maclint
