//! Rapid moves on whose way material is left.
#pragma once

#include "analyzer/machine/ways.hpp"

#include <cstdint>
#include <vector>

namespace maclint::machine {

/// A rapid move at a depth through what is still there.
struct RapidThroughWork {
    Span block;
    double z;
    Span cut; ///< the block which shows that there is material
    enum class Evidence : std::uint8_t {
        cut_later,     ///< it cuts across the way
        cut_less_deep, ///< it has cut along the way, higher
        not_lifted,    ///< the last one before the way: behind all others of its tool the tool is lifted
    } evidence;
};

[[nodiscard]] std::vector<RapidThroughWork> rapid_moves_through_work(const Program& program,
                                                                     const States& states);

} // namespace maclint::machine
