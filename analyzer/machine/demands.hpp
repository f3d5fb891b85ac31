//! Blocks that the shop asks for, held against what the machine is doing.
#pragma once

#include "analyzer/machine/step.hpp"
#include "analyzer/program/shop_demands.hpp"

#include <cstddef>
#include <optional>

namespace maclint::machine {

/// Whether the block says what the shop asks for: it holds the words that switch no state, and with it those
/// codes are in force that do.
[[nodiscard]] bool says(const Words& words, const State& after, const ControlModel& control,
                        const DemandedBlock& demanded);

/// Why a demanded block is missed.
struct Missed {
    const Known* in_force = nullptr; ///< that contradicts it; nullptr: its words stand nowhere
    char letter = 0;                 ///< of the code in force
};
/// Nothing where the block that is demanded in this place (ShopDemands::blocks) may have been said, or the
/// machine may be in the state that it asks for. What the program has not touched is off.
[[nodiscard]] std::optional<Missed> missed(const Step& step, const State& state, const ControlModel& control,
                                           std::size_t demanded);

} // namespace maclint::machine
