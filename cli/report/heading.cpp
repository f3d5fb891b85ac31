//! Compares the texts of a rule's messages up to their first argument.
#include "cli/report/heading.hpp"

#include "cli/text/letters.hpp"

#include <algorithm>
#include <cstddef>

namespace maclint::cli {
namespace {

/// Letters that two messages have to share to say together what they are about: "Unreachable", not "Missing".
constexpr std::size_t least_in_common = 10;

/// What all messages of the rule begin with, whatever their arguments are.
std::string_view common_beginning(const Rule& rule) {
    std::string_view common;
    for (const Message& message : rule.messages) {
        const std::string_view text = message.text.substr(0, message.text.find('{'));
        if (&message == &rule.messages.front()) common = text;
        const auto end = std::ranges::mismatch(common, text).in1;
        common = common.substr(0, static_cast<std::size_t>(end - common.begin()));
    }
    return common.substr(0, common.find_last_not_of(" '") + 1);
}

} // namespace

std::string heading_of(const Rule& rule) {
    if (common_beginning(rule).size() >= least_in_common) return {};
    std::string words(rule.name);
    std::ranges::replace(words, '-', ' ');
    return in_upper_case(words.substr(0, 1)) + words.substr(1) + ": ";
}

} // namespace maclint::cli
