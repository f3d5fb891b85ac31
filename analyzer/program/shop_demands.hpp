//! What a shop asks of programs for one of its machines, beside what the control takes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace maclint {

/// Both ends are allowed.
struct Bounds {
    double least = -std::numeric_limits<double>::infinity();
    double greatest = std::numeric_limits<double>::infinity();

    [[nodiscard]] constexpr bool contain(double number) const {
        return least <= number && number <= greatest;
    }
};

/// Lengths are in mm.
struct ShopLimits {
    Bounds speed, feed_per_minute, feed_per_revolution, tool;
    std::array<Bounds, 3> travel; ///< positions of a program along X, Y and Z
};

/// A block that must stand in each main program.
struct DemandedBlock {
    enum class Place : std::uint8_t {
        start,       ///< before the first move
        tool_change, ///< before each change of a tool that has worked
        end,         ///< behind the last cut
    };
    struct Word {
        char letter;
        std::optional<double> number; ///< nothing: any
    };
    Place place;
    std::string text; ///< as the configuration writes it
    std::vector<Word> words;
};

struct ShopDemands {
    ShopLimits limits;
    std::vector<DemandedBlock> blocks;

    /// A state keeps a bit for each.
    static constexpr std::size_t most_blocks = 60;
};

} // namespace maclint
