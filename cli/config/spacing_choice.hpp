//! Which blanks a shop wants in its programs: the key "spacing" of a configuration.
#pragma once

#include <cstdint>

namespace maclint::cli {

enum class Blanks : std::uint8_t { as_written, one, none };

struct SpacingChoice {
    Blanks words = Blanks::as_written;     ///< between the words of a block
    Blanks operators = Blanks::as_written; ///< around operators
    Blanks brackets = Blanks::as_written;  ///< inside of brackets; never one
    friend bool operator==(const SpacingChoice&, const SpacingChoice&) = default;
};

} // namespace maclint::cli
