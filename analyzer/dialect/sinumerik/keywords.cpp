//! The words that shape a program.
#include "analyzer/dialect/sinumerik/keywords.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/characters.hpp"

#include <algorithm>
#include <span>

namespace maclint::sinumerik {
namespace {

constexpr std::string_view openers[] = {"IF", "ELSE", "FOR", "WHILE", "LOOP", "REPEAT", "UNTIL"};
constexpr std::string_view closers[] = {"ENDIF", "ENDFOR", "ENDWHILE", "ENDLOOP"};
constexpr std::string_view jumps[] = {"GOTOF", "GOTOB", "GOTO", "GOTOC"};
constexpr std::string_view of_others[] = {"THEN", "ELSEIF", "ELSIF", "ELIF", "ENDW", "ENDREPEAT"};

std::string_view one_slip_from(std::span<const std::string_view> words, std::string_view written) {
    constexpr std::size_t shortest = 4;
    if (written.size() < shortest || std::ranges::find(words, written) != words.end()) return {};
    const auto word = std::ranges::find_if(
        words, [&](std::string_view known) { return edit_distance(written, known, 1) <= 1; });
    return word == words.end() ? std::string_view{} : *word;
}

} // namespace

bool is_structural(std::string_view capitals) {
    const auto holds = [&](std::span<const std::string_view> words) {
        return std::ranges::find(words, capitals) != words.end();
    };
    return holds(openers) || holds(closers) || holds(of_others) ||
           !one_slip_from(closers, capitals).empty() || !one_slip_from(openers, capitals).empty();
}

std::string_view closer_meant_by(std::string_view capitals) {
    if (capitals == "ENDW") return "ENDWHILE"; // of other languages
    if (capitals == "ENDREPEAT") return "UNTIL";
    return one_slip_from(closers, capitals);
}
std::string_view opener_meant_by(std::string_view capitals) { return one_slip_from(openers, capitals); }
bool is_foreign_loop_word(std::string_view capitals) {
    const bool numbered = !capitals.empty() && is_digit(capitals.back());
    if (numbered) capitals.remove_suffix(1);
    return numbered && (capitals == "DO" || capitals == "END");
}
std::string_view bare_opener_meant_by(std::string_view capitals) {
    static constexpr std::string_view bare[] = {"ELSE", "LOOP", "REPEAT"};
    return one_slip_from(bare, capitals);
}
std::string_view jump_meant_by(std::string_view capitals) { return one_slip_from(jumps, capitals); }

} // namespace maclint::sinumerik
