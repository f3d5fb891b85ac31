//! Numbers of a text that stand for blocks, programs, variables and groups.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

namespace maclint {

/// Nothing for a fraction, and beyond 15 figures, where a double does not hold every whole number: no control
/// has names as long.
[[nodiscard]] inline std::optional<std::int64_t> whole_number(double value) {
    constexpr double most = 1e15;
    if (!(std::abs(value) <= most) || value != std::floor(value)) return std::nullopt;
    return static_cast<std::int64_t>(value);
}

} // namespace maclint
