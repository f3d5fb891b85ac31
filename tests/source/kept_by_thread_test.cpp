//! What a thread keeps is one for it alone, and goes when its work is done.
#include "analyzer/source/platform/kept_by_thread.hpp"

#include <thread>

#include <gtest/gtest.h>

namespace maclint::platform {
namespace {

/// Counts those that are there.
struct Counted {
    Counted() { ++there; }
    Counted(const Counted&) = delete;
    Counted& operator=(const Counted&) = delete;
    ~Counted() { --there; }
    inline static int there = 0;
};
struct FirstOwner;
struct SecondOwner;

TEST(KeptByThread, IsTheSameWhenAskedForAgain) {
    const auto& first = KeptByThread<int, FirstOwner>::get(7);
    EXPECT_EQ(&(KeptByThread<int, FirstOwner>::get(8)), &first);
    EXPECT_EQ(first, 7);
    EXPECT_NE(&(KeptByThread<int, SecondOwner>::get(9)), &first);
}

TEST(KeptByThread, GoesWithTheWorkOfItsThread) {
    std::thread([] {
        const ThreadWork work;
        static_cast<void>(KeptByThread<Counted, FirstOwner>::get());
        static_cast<void>(KeptByThread<Counted, SecondOwner>::get());
        EXPECT_EQ(Counted::there, 2);
    }).join();
    EXPECT_EQ(Counted::there, 0);
}

TEST(KeptByThread, IsMadeAnewForWorkThatComesLater) {
    for (const int value : {1, 2}) {
        const ThreadWork work;
        EXPECT_EQ((KeptByThread<int, Counted>::get(value)), value);
    }
}

} // namespace
} // namespace maclint::platform
