//! Holds names against each other letter by letter.
#include "analyzer/dialect/near_names.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/characters.hpp"

#include <algorithm>
#include <cstddef>

namespace maclint {
namespace {

/// Whether the character is a word of its own in the name: `B` of `B_ALT`, of `COUNT_B`.
bool stands_alone(std::string_view name, std::size_t at) {
    return (at == 0 || name[at - 1] == '_') && (at + 1 == name.size() || name[at + 1] == '_');
}

/// Whether the names have different letters at the place, which tell two variables of a row apart: X_POS and
/// Y_POS, DIST_X1 and DIST_Y1, COUNT_A and COUNT_B.
bool are_told_apart(std::string_view written, std::string_view known, std::size_t at) {
    constexpr std::string_view axes = "XYZABCUVWIJK";
    if (written.size() != known.size() || at == written.size() ||
        written.substr(at + 1) != known.substr(at + 1))
        return false;
    const auto is_axis = [&](char letter) { return axes.find(letter) != std::string_view::npos; };
    return stands_alone(written, at) || (is_axis(written[at]) && is_axis(known[at]));
}

} // namespace

bool is_one_letter_off(std::string_view written, std::string_view known) {
    constexpr std::size_t shortest = 5; // of the variable: a letter of it may be lost
    if (written.size() + 1 < shortest || known.size() < shortest || edit_distance(written, known, 1) != 1)
        return false;
    const auto figures = [](std::string_view name) { return std::ranges::count_if(name, is_digit); };
    const auto differ = std::ranges::mismatch(written, known);
    const auto is_figure = [](auto at, auto end) { return at != end && is_digit(*at); };
    return figures(written) == figures(known) && !is_figure(differ.in1, written.end()) &&
           !is_figure(differ.in2, known.end()) &&
           !are_told_apart(written, known, static_cast<std::size_t>(differ.in1 - written.begin()));
}

bool is_typing_slip(std::string_view written, std::string_view meant, bool may_be_program) {
    constexpr std::size_t shortest = 4;
    if (meant.size() < shortest || written == meant) return false;
    const auto at = static_cast<std::size_t>(std::ranges::mismatch(written, meant).in1 - written.begin());
    const std::string_view rest = written.substr(at), rest_meant = meant.substr(at);
    if (written.size() == meant.size())
        return rest.size() >= 2 && rest[0] == rest_meant[1] && rest[1] == rest_meant[0] &&
               rest.substr(2) == rest_meant.substr(2);
    if (meant.size() == shortest && may_be_program) return false; // too many names are as near
    // LIFT and ROTA are names of their own, no TLIFT and PROTA.
    const std::size_t shortest_with_a_loss = may_be_program ? 6 : 5;
    if (written.size() + 1 == meant.size())
        return at > 0 && meant.size() >= shortest_with_a_loss && rest == rest_meant.substr(1);
    return written.size() == meant.size() + 1 && at > 0 && rest[0] == written[at - 1] &&
           rest.substr(1) == rest_meant;
}

} // namespace maclint
