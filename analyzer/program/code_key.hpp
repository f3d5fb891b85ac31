//! Codes as whole numbers, for tables that are sorted by them.
#pragma once

#include <cmath>
#include <cstdint>

namespace maclint {

/// A letter and a number of at most three decimals as one number; -1 for a number that is no code's.
[[nodiscard]] inline std::int64_t code_key(char letter, double code) {
    constexpr double decimals = 1000;
    constexpr std::int64_t letters = 256;
    constexpr double beyond_codes = 1e6;
    if (!(code >= 0 && code < beyond_codes)) return -1;
    return std::llround(code * decimals) * letters + static_cast<unsigned char>(letter);
}

} // namespace maclint
