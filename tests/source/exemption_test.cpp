//! Exemptions are on unless their thread does without them.
#include "analyzer/source/exemption.hpp"

#include <array>
#include <thread>

#include <gtest/gtest.h>

namespace maclint {
namespace {

constexpr Exemption one;
constexpr Exemption other;

TEST(Exemption, IsOnUnlessItIsSwitchedOff) {
    EXPECT_TRUE(one.is_on());
    const std::array<const Exemption*, 1> off{&one};
    {
        const WithoutExemptions without(off);
        EXPECT_FALSE(one.is_on());
        EXPECT_TRUE(other.is_on());
    }
    EXPECT_TRUE(one.is_on());
}

TEST(Exemption, IsOnAgainWhereAnInnerScopeSwitchesOffOthers) {
    const std::array<const Exemption*, 2> off{&one, &other};
    const WithoutExemptions both(off);
    EXPECT_FALSE(other.is_on());
    {
        const WithoutExemptions first(std::span<const Exemption* const>(off).first(1));
        EXPECT_FALSE(one.is_on());
        EXPECT_TRUE(other.is_on());
    }
    EXPECT_FALSE(other.is_on());
}

TEST(Exemption, IsSwitchedOffForItsThreadAlone) {
    const std::array<const Exemption*, 1> off{&one};
    const WithoutExemptions without(off);
    bool elsewhere = false;
    std::thread([&] { elsewhere = one.is_on(); }).join();
    EXPECT_TRUE(elsewhere);
}

} // namespace
} // namespace maclint
