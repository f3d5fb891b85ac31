//! Reads the words of a macro one by one.
#include "analyzer/dialect/sinumerik/macros.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/characters.hpp"
#include "analyzer/dialect/numbers.hpp"
#include "analyzer/dialect/sinumerik/g_codes.hpp"
#include "analyzer/dialect/sinumerik/tables.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace maclint::sinumerik {
namespace {

bool is_number(std::string_view text) {
    if (!text.empty() && (text.front() == '-' || text.front() == '+')) text.remove_prefix(1);
    return std::ranges::any_of(text, is_digit) && std::ranges::count(text, '.') <= 1 &&
           std::ranges::all_of(text, [](char c) { return is_digit(c) || c == '.'; });
}

/// Whether what the function does is known: it is none that ends or stops, nor one that may turn the spindle.
bool read_function(double number, GivenWord& word) {
    constexpr double of_program[] = {0, 1, 2, 17, 19, 30, 70}; // M19, M70: spindle [T]
    if (std::ranges::find(of_program, number) != std::end(of_program)) return false;
    word.changes_tool |= number == functions::tool_change;
    if (const auto group = control().group_of('M', number)) word.sets.emplace_back(*group, number);
    return true;
}

/// Whether what the word does is known.
bool read_word(std::string_view capitals, GivenWord& word) {
    const bool is_numbered = capitals.size() > 1 && is_digit(capitals[1]);
    if (const auto setting = setting_of(is_numbered ? code_name(capitals) : std::string(capitals))) {
        if (setting->takes_axes) return false;
        if (setting->sets) word.sets.emplace_back(setting->sets->group, setting->sets->code);
        word.moves |= setting->moves || !setting->sets; // SUPA: from where the words beside it count
        return true;
    }
    if (!is_number(capitals.substr(1))) return false;
    constexpr std::string_view axes = "XYZABCUVW";
    const double number = read_number(capitals.substr(1)).value;
    switch (capitals.front()) {
    case 'M': return read_function(number, word);
    case 'F': word.sets.emplace_back(*control().group_with(ModalRole::feed), number); return true;
    case 'S': word.sets.emplace_back(*control().group_with(ModalRole::speed), number); return true;
    case 'D':
    case 'H': return true;
    default: word.moves = true; return axes.find(capitals.front()) != std::string_view::npos;
    }
}

} // namespace

GivenWord read_macro(std::string name, std::string_view body) {
    constexpr std::string_view blanks = " \t";
    GivenWord word{std::move(name), false};
    std::string capitals = in_capitals(body);
    for (std::string_view rest = capitals; !rest.empty();) {
        const std::size_t end = std::min(rest.find_first_of(blanks), rest.size());
        const std::string_view written = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        if (written.empty()) continue;
        if (!read_word(written, word)) return {word.name, false};
        word.is_known = true;
    }
    return word;
}

} // namespace maclint::sinumerik
