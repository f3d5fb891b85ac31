//! Lines as the text, concise and GitHub reports, the tables of numbers and standard error have them.
#include "cli/input/report_lines.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

namespace maclint::cli {
namespace {

constexpr std::array<std::string_view, 3> severities = {"error", "warning", "note"};
constexpr std::size_t code_length = 6; ///< of "MAC303", "DIN330"
constexpr std::string_view digits = "0123456789";
constexpr std::string_view blanks = " \t";

bool is_digit(char c) { return digits.find(c) != std::string_view::npos; }

bool is_code(std::string_view text) {
    return text.size() == code_length && (text.starts_with("MAC") || text.starts_with("DIN")) &&
           std::ranges::all_of(text.substr(3), is_digit);
}

/// Takes a number off the front; false: there is none.
bool take_number(std::string_view& text) {
    const std::size_t length = std::min(text.size(), text.find_first_not_of(digits));
    text.remove_prefix(length);
    return length > 0;
}

bool take(std::string_view& text, std::string_view word) {
    if (!text.starts_with(word)) return false;
    text.remove_prefix(word.size());
    return true;
}

/// "3 files", "1 file"
bool take_counted(std::string_view& text, std::string_view noun) {
    if (!take_number(text) || !take(text, " ") || !take(text, noun)) return false;
    take(text, "s");
    return true;
}

/// Takes "error[MAC303]" off the front.
bool take_severity(std::string_view& text) {
    const auto taken = std::ranges::any_of(severities, [&](auto severity) { return take(text, severity); });
    if (!taken || !take(text, "[") || !is_code(text.substr(0, code_length))) return false;
    text.remove_prefix(code_length);
    return take(text, "]");
}

/// "O1.nc:4:1"
bool is_place(std::string_view text) {
    for (int i = 0; i < 2; ++i) {
        const std::size_t colon = text.find_last_not_of(digits);
        if (colon == std::string_view::npos || colon == 0 || text[colon] != ':') return false;
        if (colon + 1 == text.size()) return false;
        text = text.substr(0, colon);
    }
    return true;
}

/// A program could hide what it does in front of a comment: `G0 X1. (O1.nc:4:1: error[MAC301] …)`.
bool has_open_bracket(std::string_view text) {
    const auto opens = [&](char open, char close) {
        const std::size_t last = text.rfind(open);
        return last != std::string_view::npos && text.find(close, last) == std::string_view::npos;
    };
    return opens('(', ')') || opens('[', ']');
}

bool starts_with_any(std::string_view line, std::span<const std::string_view> heads) {
    return std::ranges::any_of(heads, [&](std::string_view head) { return line.starts_with(head); });
}

} // namespace

bool is_headline(std::string_view line) { return take_severity(line) && line.starts_with(": "); }

bool is_concise_finding(std::string_view line) {
    for (std::size_t at = line.find(": "); at != std::string_view::npos; at = line.find(": ", at + 1)) {
        std::string_view rest = line.substr(at + 2);
        const std::string_view place = line.substr(0, at);
        if (take_severity(rest) && rest.starts_with(' ') && is_place(place)) return !has_open_bracket(place);
    }
    return false;
}

bool is_workflow_command(std::string_view line) {
    constexpr std::array<std::string_view, 4> heads = {
        "::error file=", "::warning file=", "::notice file=", "::error title=maclint"};
    return starts_with_any(line, heads);
}

bool is_message(std::string_view line) {
    constexpr std::array<std::string_view, 2> heads = {"maclint: error: ", "maclint: note: "};
    return starts_with_any(line, heads);
}

bool is_summary(std::string_view line) {
    if (!take(line, "no findings") && !take(line, "no new findings")) {
        do
            if (!take_number(line) || !take(line, " ") ||
                std::ranges::none_of(severities, [&](auto severity) { return take(line, severity); }))
                return false;
        while ((take(line, "s"), take(line, ", ")));
        if (!take(line, " in ") || !take_counted(line, "file")) return false;
    }
    return take(line, " (") && take_number(line) && take(line, " checked") && line.ends_with(')') &&
           (line.size() == 1 || line.starts_with(", "));
}

bool is_not_shown(std::string_view line) {
    std::string_view known = line;
    return (take_counted(line, "step") && line == " of paths not shown; --path full shows them") ||
           (take_counted(known, "known finding") && known.starts_with(" of ") &&
            known.ends_with(" not shown"));
}

bool is_timing(std::string_view line) { return line.starts_with("timing: "); }

bool is_count(std::string_view line) {
    if (!take(line, "  ")) return false;
    if (line == "none") return true;
    if (take(line, "and ")) return take_counted(line, "more file") && line.empty();
    line.remove_prefix(std::min(line.size(), line.find_first_not_of(' ')));
    return take_number(line) && take(line, "  ") && !line.empty();
}

std::size_t margin_of_place(std::string_view line, std::string_view arrow) {
    const std::size_t margin = std::min(line.size(), line.find_first_not_of(' '));
    line.remove_prefix(margin);
    return take(line, arrow) && take(line, " ") && is_place(line) ? margin : 0;
}

bool is_row(std::string_view line, std::size_t margin) {
    if (line.size() < margin + 2 || line.substr(margin, 2) != " |") return false;
    std::string_view number = line.substr(0, margin);
    number.remove_prefix(std::min(number.size(), number.find_first_not_of(' ')));
    return std::ranges::all_of(number, is_digit) && (line.size() == margin + 2 || line[margin + 2] == ' ');
}

bool is_reference(std::string_view text) { return take(text, "more: maclint explain ") && is_code(text); }

bool is_like_tape_mark(std::string_view line) {
    const std::size_t first = line.find_first_not_of(blanks);
    if (first == std::string_view::npos) return false;
    return line[first] == '%' || line[line.find_last_not_of(blanks)] == '%' || holds_tape_mark_as_block(line);
}

bool holds_tape_mark_as_block(std::string_view line) {
    for (std::size_t at = line.find('%'); at != std::string_view::npos; at = line.find('%', at + 1)) {
        const std::size_t before = line.substr(0, at).find_last_not_of(blanks);
        const bool heads_block = before != std::string_view::npos && line[before] == ';';
        if (heads_block && line.find_first_not_of(blanks, at + 1) != std::string_view::npos) return true;
    }
    return false;
}

std::string without_colours(std::string_view line) {
    constexpr std::string_view begin = "\x1B[";
    std::string plain;
    for (std::size_t at = line.find(begin); at != std::string_view::npos; at = line.find(begin)) {
        plain += line.substr(0, at);
        line.remove_prefix(at + begin.size());
        const std::size_t end = line.find_first_not_of("0123456789;");
        if (end == std::string_view::npos || line[end] != 'm') return plain.append(begin).append(line);
        line.remove_prefix(end + 1);
    }
    return plain.append(line);
}

} // namespace maclint::cli
