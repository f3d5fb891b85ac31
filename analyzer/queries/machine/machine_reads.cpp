//! Looks through the expressions of a program.
#include "analyzer/queries/machine/machine_reads.hpp"

#include <algorithm>
#include <cctype>

namespace maclint::queries {
namespace {

bool begins_with(std::string_view text, std::string_view value) {
    const auto same = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; };
    const bool begins =
        text.size() >= value.size() && std::ranges::equal(text.substr(0, value.size()), value, same);
    return begins &&
           (text.size() == value.size() || std::isdigit(static_cast<unsigned char>(text[value.size()])) == 0);
}

} // namespace

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
