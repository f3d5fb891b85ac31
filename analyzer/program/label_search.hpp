//! In which direction a jump looks.
#pragma once

#include <cstdint>

namespace maclint {

/// Where the control looks for the block that a jump names, seen from the jump's own block.
enum class LabelSearch : std::uint8_t {
    forward_then_top, ///< from its own block to the end, then from the top
    forward,          ///< after it
    backward,         ///< from its own block to the top
    forward_then_backward,
};

} // namespace maclint
