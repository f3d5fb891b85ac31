//! One pass over the bytes of a block.
#include "analyzer/dialect/fanuc/plausible.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/fanuc/tokens.hpp"

#include <string>

namespace maclint::fanuc {
namespace {

constexpr std::size_t farthest_value = 48;
constexpr std::size_t most_parse_errors = 32;

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

/// The words of an output or naming statement are free text.
bool holds_free_text(std::string_view block) {
    const std::string capitals = in_capitals(block);
    return capitals.find("PRNT") != std::string::npos || capitals.find("SETVN") != std::string::npos;
}

} // namespace

bool is_plausible(std::string_view block) {
    std::size_t without_value = 0; // digits and names, `[#DEPTH]`
    std::size_t parse_errors = 0;  // commas without a letter behind them, values that follow a value
    char before = '\0';
    for (std::size_t at = 0; at < block.size(); ++at) {
        const char c = block[at];
        if (c == ' ' || c == '\t') continue;
        if (c == '(') {
            at = std::min(block.find_first_of(")\r\n", at), block.size());
            continue;
        }
        const bool ends_value = before == ']' || is_digit(before);
        if ((c == '[' || c == '#') && ends_value) ++parse_errors;
        if (before == ',' && !is_letter(c)) ++parse_errors;
        const bool names =
            c == '#' && at + 1 < block.size() && (is_letter(block[at + 1]) || block[at + 1] == '_');
        if (is_digit(c) || names)
            without_value = 0;
        else if (++without_value > farthest_value)
            break;
        before = c;
    }
    if (parse_errors > most_parse_errors) return false;
    return without_value <= farthest_value || holds_free_text(block);
}

} // namespace maclint::fanuc
