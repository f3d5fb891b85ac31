//! Holds names against each other letter by letter.
#include "analyzer/dialect/near_names.hpp"

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

/// Whether the first two letters stand the other way round, and nothing else differs. Both are as long.
bool are_exchanged(std::string_view rest, std::string_view known) {
    return rest.size() >= 2 && rest[0] == known[1] && rest[1] == known[0] &&
           rest.substr(2) == known.substr(2);
}

/// Whether one letter, or an exchange with its neighbour, at the place of the first difference makes the one
/// name of the other. As edit_distance tells it, but thousands of names are held against thousands.
bool is_one_edit(std::string_view written, std::string_view known, std::size_t at) {
    const std::size_t longer = std::max(written.size(), known.size());
    if (longer - std::min(written.size(), known.size()) > 1 || at == longer) return false;
    const auto behind = [&](std::string_view name) {
        return name.substr(at + (name.size() == longer ? 1 : 0));
    };
    if (behind(written) == behind(known)) return true;
    const std::string_view rest = written.substr(at), rest_known = known.substr(at);
    return written.size() == known.size() && are_exchanged(rest, rest_known);
}

} // namespace

bool is_one_letter_off(std::string_view written, std::string_view known) {
    constexpr std::size_t shortest = 5; // of the variable: a letter of it may be lost
    if (written.size() + 1 < shortest || known.size() < shortest) return false;
    const auto differ = std::ranges::mismatch(written, known);
    if (!is_one_edit(written, known, static_cast<std::size_t>(differ.in1 - written.begin()))) return false;
    const auto figures = [](std::string_view name) { return std::ranges::count_if(name, is_digit); };
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
    if (written.size() == meant.size()) return are_exchanged(rest, rest_meant);
    if (meant.size() == shortest && may_be_program) return false; // too many names are as near
    // LIFT and ROTA are names of their own, no TLIFT and PROTA.
    const std::size_t shortest_with_a_loss = may_be_program ? 6 : 5;
    if (written.size() + 1 == meant.size())
        return at > 0 && meant.size() >= shortest_with_a_loss && rest == rest_meant.substr(1);
    return written.size() == meant.size() + 1 && at > 0 && rest[0] == written[at - 1] &&
           rest.substr(1) == rest_meant;
}

} // namespace maclint
