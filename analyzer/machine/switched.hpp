//! What is known of the switches of a machine at one place of a program.
#pragma once

#include "analyzer/program/switches.hpp"
#include "analyzer/source/span.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace maclint::machine {

/// All that a switch can be, each on some path.
struct Switched {
    static constexpr std::uint8_t callers = 1; ///< as it was when the program began
    static constexpr std::uint8_t off = 2;
    static constexpr std::uint8_t on = 4;
    static constexpr std::uint8_t unknown = 8; ///< nobody can say

    std::uint8_t can_be = 0;
    /// The first block in the text that has switched it on, or off; nowhere: none has.
    Offset on_at = nowhere, off_at = nowhere;

    static constexpr Offset nowhere = 0xFFFFFFFF;
    [[nodiscard]] constexpr bool is_surely_on() const { return can_be == on; }
    [[nodiscard]] constexpr bool is_surely_off() const { return can_be == off; }
};

/// Those of all switches of the control.
struct SwitchState {
    bool is_reached = false;
    std::array<Switched, most_switches> all = {};

    /// Takes in what another path says; whether that changes anything.
    bool add(const SwitchState& other);
    /// After a call in the block: what the called program has left alone is as before.
    void go_on_with(const SwitchState& end_of_called, Offset block);
    void forget();
};

} // namespace maclint::machine
