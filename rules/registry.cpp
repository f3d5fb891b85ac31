//! The explicit list of all rules, in the order of their codes. A new rule is one declaration and one line
//! here.
#include "rules/rule.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

namespace maclint {
namespace rules {
// Declarations, sorted by code.
} // namespace rules

namespace {

const std::array<const Rule*, 0> list{};

bool equal_without_case(std::string_view a, std::string_view b) {
    return std::ranges::equal(
        a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

bool is_alias(std::string_view aliases, std::string_view code) {
    for (std::size_t begin = 0; begin < aliases.size();) {
        const std::size_t end = std::min(aliases.find(' ', begin), aliases.size());
        if (equal_without_case(aliases.substr(begin, end - begin), code)) return true;
        begin = end + 1;
    }
    return false;
}

} // namespace

std::span<const Rule* const> all_rules() { return list; }

const Rule* find_rule(std::string_view code_or_name) {
    const auto found = std::ranges::find_if(list, [&](const Rule* rule) {
        return equal_without_case(rule->code, code_or_name) || equal_without_case(rule->name, code_or_name) ||
               is_alias(rule->aliases, code_or_name);
    });
    return found == list.end() ? nullptr : *found;
}

} // namespace maclint
