//! Numbers of plain blocks.
#include "analyzer/syntax/plain_scanner.hpp"

#include <array>
#include <charconv>
#include <string>

namespace maclint::syntax {

Lane scan_block(std::string_view text, Offset begin, const PlainTables& tables, PlainBlock& block) {
    return PlainScanner<NoWords>(text, begin, tables, block, {}).run();
}

double scaled(std::uint64_t mantissa, unsigned decimals) {
    static constexpr std::array<double, 16> powers{1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                   1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    return static_cast<double>(mantissa) / powers[decimals];
}

double read_long_number(std::string_view text) {
    std::string digits;
    for (const char c : text)
        if ((c >= '0' && c <= '9') || c == '.') digits += c;
    double value = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value;
}

} // namespace maclint::syntax
