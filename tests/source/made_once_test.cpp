//! What is made when it is first asked for is made once, whoever asks.
#include "analyzer/source/made_once.hpp"

#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace maclint {
namespace {

TEST(MadeOnce, IsMadeWhenItIsAskedForAndNotAgain) {
    MadeOnce<std::string> name;
    int makes = 0;
    const auto make = [&] {
        ++makes;
        return std::string("O9100");
    };
    EXPECT_EQ(makes, 0);
    const std::string& first = name.get(make);
    EXPECT_EQ(first, "O9100");
    EXPECT_EQ(&name.get(make), &first);
    EXPECT_EQ(makes, 1);
}

TEST(MadeOnce, ThreadsThatAskAtATimeGetTheSame) {
    MadeOnce<int> number;
    std::atomic<int> makes = 0, sum = 0;
    {
        std::vector<std::jthread> threads;
        for (int i = 0; i < 8; ++i)
            threads.emplace_back([&] {
                sum += number.get([&] {
                    std::this_thread::yield();
                    return ++makes;
                });
            });
    }
    EXPECT_EQ(makes, 1);
    EXPECT_EQ(sum, 8);
}

TEST(MadeOnce, IsAskedForAgainWhereItCouldNotBeMade) {
    MadeOnce<int> number;
    EXPECT_THROW((void)number.get([]() -> int { throw std::runtime_error("no memory"); }),
                 std::runtime_error);
    EXPECT_EQ(number.get([] { return 7; }), 7);
}

} // namespace
} // namespace maclint
