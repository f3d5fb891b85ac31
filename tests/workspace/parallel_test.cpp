//! Every piece of work is done once, on however many threads, and what one throws arrives.
#include "analyzer/workspace/parallel.hpp"

#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace maclint {
namespace {

TEST(Parallel, EveryPieceOfWorkIsDoneOnce) {
    for (const unsigned jobs : {1U, 2U, 7U})
        for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{5}, std::size_t{1000}}) {
            std::vector<std::atomic<int>> done(count);
            for_each_parallel(count, jobs, [&](std::size_t i) { ++done[i]; });
            for (const auto& times : done) EXPECT_EQ(times, 1);
        }
}

TEST(Parallel, OneThreadWorksInOrder) {
    std::vector<std::size_t> order;
    for_each_parallel(4, 1, [&](std::size_t i) { order.push_back(i); });
    EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 3}));
}

TEST(Parallel, NoMoreThreadsWorkThanAsked) {
    std::mutex mutex;
    std::set<std::thread::id> seen;
    const auto work = [&](std::size_t) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        const std::scoped_lock lock(mutex);
        seen.insert(std::this_thread::get_id());
    };
    for_each_parallel(20, 1, work);
    EXPECT_EQ(seen, std::set{std::this_thread::get_id()});
    seen.clear();
    for_each_parallel(20, 2, work);
    EXPECT_LE(seen.size(), 2U);
    seen.clear();
    for_each_parallel(1, 8, work);
    EXPECT_EQ(seen, std::set{std::this_thread::get_id()});
}

TEST(Parallel, WhatTheWorkThrowsIsThrownAndNothingNewIsBegun) {
    std::vector<std::size_t> begun;
    const auto work = [&](std::size_t i) {
        begun.push_back(i);
        if (i == 2) throw std::runtime_error("broken");
    };
    EXPECT_THROW(for_each_parallel(10, 1, work), std::runtime_error);
    EXPECT_EQ(begun, (std::vector<std::size_t>{0, 1, 2}));
    EXPECT_THROW(for_each_parallel(100, 3, [](std::size_t) { throw std::logic_error("all broken"); }),
                 std::logic_error);
}

} // namespace
} // namespace maclint
