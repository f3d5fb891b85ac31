//! Looks through the expressions of a program.
#include "analyzer/queries/machine/machine_reads.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <system_error>

namespace maclint::queries {
namespace {

bool begins_with(std::string_view text, std::string_view value) {
    const auto same = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; };
    const bool begins =
        text.size() >= value.size() && std::ranges::equal(text.substr(0, value.size()), value, same);
    return begins &&
           (text.size() == value.size() || std::isdigit(static_cast<unsigned char>(text[value.size()])) == 0);
}

/// The number before the bracket; nothing of another expression.
std::optional<int> number_in(std::string_view text, std::string_view letters) {
    constexpr std::size_t most_digits = 3;
    const std::size_t end = text.find('(');
    if (text.find(')') != text.size() - 1) return std::nullopt; // "#a1(Z,1)>5" only begins so
    if (end == std::string_view::npos || end <= letters.size() || end > letters.size() + most_digits)
        return std::nullopt;
    if (!begins_with(text.substr(0, letters.size()), letters)) return std::nullopt;
    int number = 0;
    const std::string_view digits = text.substr(letters.size(), end - letters.size());
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    return read.ec == std::errc{} && read.ptr == digits.data() + digits.size() ? std::optional(number)
                                                                               : std::nullopt;
}

} // namespace

std::vector<ControlRead> reads_of_control(const Program& program, std::string_view letters) {
    std::vector<ControlRead> reads;
    for (const Expression& expression : program.expressions)
        if (const auto number = number_in(program.slice(expression.span), letters))
            reads.push_back({expression.span, *number});
    std::ranges::sort(reads, {}, [](const ControlRead& read) { return read.span.begin; });
    const auto again = std::ranges::unique(
        reads, [](const ControlRead& one, const ControlRead& other) { return one.span == other.span; });
    reads.erase(again.begin(), again.end());
    return reads;
}

bool may_be_read_behind(const Program& program, std::string_view value, Offset place) {
    return std::ranges::any_of(program.expressions,
                               [&](const Expression& expression) {
                                   return expression.span.begin >= place &&
                                          begins_with(program.slice(expression.span), value);
                               }) ||
           std::ranges::any_of(program.effects, [&](const Effect& effect) {
               return effect.span.begin >= place && (std::holds_alternative<Call>(effect.what) ||
                                                     std::holds_alternative<UnreadableBlock>(effect.what));
           });
}

} // namespace maclint::queries
