//! Numbers: exact for up to 15 digits, which is more than any control keeps.
#include "analyzer/dialect/numbers.hpp"

#include "analyzer/syntax/plain_scanner.hpp"

namespace maclint {
namespace {

constexpr unsigned exact_digits = 15;

} // namespace

Number read_number(std::string_view text) {
    std::uint64_t mantissa = 0;
    unsigned digits = 0;
    unsigned decimals = 0;
    bool point = false;
    bool negative = false;
    for (const char c : text) {
        if (c >= '0' && c <= '9') {
            if (digits == 0 && c == '0' && !point) continue;
            if (++digits <= exact_digits) mantissa = mantissa * 10 + static_cast<std::uint64_t>(c - '0');
            if (point) ++decimals;
        } else if (c == '.') {
            point = true;
        } else if (c == '-') {
            negative = true;
        }
    }
    const double value = digits <= exact_digits && decimals <= exact_digits
                             ? syntax::scaled(mantissa, decimals)
                             : syntax::read_long_number(text);
    return {negative && value != 0 ? -value : value, point};
}

std::optional<std::int64_t> read_integer(std::string_view text) {
    constexpr unsigned longest = 18;
    std::int64_t value = 0;
    unsigned digits = 0;
    for (const char c : text) {
        if (c < '0' || c > '9') continue;
        if (++digits > longest) return std::nullopt;
        value = value * 10 + (c - '0');
    }
    return digits == 0 ? std::nullopt : std::optional(value);
}

} // namespace maclint
