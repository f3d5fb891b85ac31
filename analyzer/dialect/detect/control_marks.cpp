//! The table of marks, and the sums over it.
#include "analyzer/dialect/detect/control_marks.hpp"

#include <algorithm>
#include <iterator>

namespace maclint::detect {
namespace {

/// `#30003.036`: five digits, a point and more digits.
bool parameter_variable(const Line& line) {
    constexpr std::size_t digits = 5;
    const std::string_view code = line.code();
    for (std::size_t at = code.find('#'); at != std::string_view::npos; at = code.find('#', at + 1)) {
        std::size_t end = at + 1;
        while (end < code.size() && is_digit(code[end])) ++end;
        if (end - at - 1 == digits && code[end - digits] == '3' && end + 1 < code.size() &&
            code[end] == '.' && is_digit(code[end + 1]))
            return true;
    }
    return false;
}

/// `#10000` to `#10999`: common variables of a Haas, tool offsets of others.
bool high_common(const Line& line) {
    constexpr std::size_t digits = 5;
    const std::string_view code = line.code();
    for (std::size_t at = code.find("#10"); at != std::string_view::npos; at = code.find("#10", at + 1)) {
        std::size_t end = at + 1;
        while (end < code.size() && is_digit(code[end])) ++end;
        if (end - at - 1 == digits) return true;
    }
    return false;
}

bool holds_word(std::string_view text, std::string_view word) {
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || !is_capital(text[at - 1])) && (end == text.size() || !is_capital(text[end])))
            return true;
    }
    return false;
}

bool code_with(const Line& line, char letter, std::int32_t code, std::string_view with) {
    constexpr std::int32_t tenths = 10;
    return line.has(letter, code * tenths, code * tenths) &&
           std::ranges::any_of(with, [&](char word) { return line.word(word) != nullptr; });
}

bool block_look_ahead(const Line& line) { return line.is_plain() && code_with(line, 'G', 103, "P"); }
bool smoothness(const Line& line) { return line.is_plain() && code_with(line, 'G', 187, "PE"); }
bool more_work_offsets(const Line& line) { return line.is_plain() && code_with(line, 'G', 154, "P"); }
bool local_program(const Line& line) { return line.is_plain() && code_with(line, 'M', 97, "P"); }
bool tool_data(const Line& line) { return line.code().find("#8550") != std::string_view::npos; }
bool next_generation(const Line& line) { return holds_word(line.comment(), "NGC"); }
bool maker(const Line& line) { return holds_word(line.comment(), "HAAS"); }
bool says_its_control(const Line& line) {
    return maker(line) && (holds_word(line.comment(), "CONTROLLER") || holds_word(line.comment(), "CONTROL"));
}

enum class Stands : std::uint8_t {
    in_code,
    in_remark,
    beside_code, ///< in code, and counts only beside another one there
};

struct Mark {
    std::string_view control;
    int points;
    Stands stands;
    std::uint64_t characters; ///< that the line must hold
    bool (*holds)(const Line&);
    std::string_view called;
    [[maybe_unused]] std::string_view source;
};

// clang-format off
constexpr Mark marks[] = {
    {"haas", 2, Stands::in_code,     characters_of("#3."), parameter_variable, "a variable like #30003.036",  "T: Haas macro variables of settings and parameters"},
    {"haas", 1, Stands::in_code,     characters_of("G103P"), block_look_ahead,   "G103 with P",                 "T: Haas G codes, limit block look-ahead"},
    {"haas", 1, Stands::in_code,     characters_of("G187"), smoothness,         "G187 with P or E",            "T: Haas G codes, smoothness level"},
    {"haas", 1, Stands::in_code,     characters_of("G154P"), more_work_offsets,  "G154 with P",                 "T: Haas G codes, work coordinates P1-P99"},
    {"haas", 1, Stands::in_code,     characters_of("M97P"), local_program,      "M97 with P",                  "T: Haas M codes, local subprogram call"},
    {"haas", 1, Stands::in_code,     characters_of("#8550"), tool_data,          "#8550",                       "T: Haas macro variables, individual tool data"},
    {"haas", 1, Stands::in_remark,   characters_of("NGC"), next_generation,    "'NGC' in a remark",           "T: Haas Next Generation Control"},
    {"haas", 1, Stands::beside_code, characters_of("#10"),   high_common,        "a variable like #10100",      "T: Haas macro variables, #10000 to #10999 are common ones"},
    {"haas", 1, Stands::in_remark,   characters_of("HAAS"), maker,              "'HAAS' in a remark",          "T: the maker's name"},
    {"haas", 1, Stands::in_remark,   characters_of("HAASCONTROL"), says_its_control,   "a remark that names the control", "T"},
};
// clang-format on

constexpr int enough_points = 2;

} // namespace

void ControlEvidence::add(const Line& line, std::size_t number) {
    static_assert(std::size(marks) <= most_marks);
    for (std::size_t i = 0; i < std::size(marks); ++i)
        if (lines_[i] == 0 && (marks[i].characters & ~line.characters()) == 0 && marks[i].holds(line))
            lines_[i] = static_cast<std::uint32_t>(number);
}

int ControlEvidence::points_of(std::string_view control) const {
    int points = 0, beside_code = 0;
    bool code = false;
    for (std::size_t i = 0; i < std::size(marks); ++i) {
        const Mark& mark = marks[i];
        if (lines_[i] == 0 || mark.control != control) continue;
        (mark.stands == Stands::beside_code ? beside_code : points) += mark.points;
        code |= mark.stands == Stands::in_code;
    }
    return code ? points + beside_code : points;
}

std::string_view ControlEvidence::verdict() const {
    std::string_view best;
    int most = enough_points - 1;
    for (const Mark& mark : marks) {
        if (points_of(mark.control) <= most) continue;
        best = mark.control;
        most = points_of(mark.control);
    }
    return best;
}

std::string ControlEvidence::reason() const {
    std::string text;
    const std::string_view control = verdict();
    for (std::size_t i = 0; i < std::size(marks); ++i)
        if (lines_[i] != 0 && marks[i].control == control)
            text += (text.empty() ? "" : ", ") + std::string(marks[i].called) + " on line " +
                    std::to_string(lines_[i]);
    return text;
}

} // namespace maclint::detect
