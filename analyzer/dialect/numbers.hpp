//! Reads the numbers of words and expressions: digits with a point, no exponent, blanks allowed.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace maclint {

struct Number {
    double value;
    bool decimal_point;
};

/// The number in `text`, which may hold a sign and blanks; what is no digit, sign or point is passed over.
[[nodiscard]] Number read_number(std::string_view text);

/// The whole number in the digits of `text`, as long as it has at most 18 of them.
[[nodiscard]] std::optional<std::int64_t> read_integer(std::string_view text);

} // namespace maclint
