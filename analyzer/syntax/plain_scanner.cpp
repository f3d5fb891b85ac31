//! Numbers of plain blocks.
#include "analyzer/syntax/plain_scanner.hpp"

#include <charconv>
#include <string>

namespace maclint::syntax {

Lane scan_block(std::string_view text, Offset begin, const PlainTables& tables, PlainBlock& block) {
    return PlainScanner<NoWords>(text, begin, tables, block, {}).run();
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
