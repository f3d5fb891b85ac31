//! Looks at the first line only: what the programs say that a report quotes is no sign.
#include "cli/input/own_report.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace maclint::cli {
namespace {

constexpr std::array<std::string_view, 3> severities = {"error", "warning", "note"};

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// "[MAC303]"
bool begins_with_code(std::string_view text) {
    constexpr std::size_t length = 8;
    return text.size() >= length && text[0] == '[' && text[length - 1] == ']' &&
           std::ranges::all_of(text.substr(4, 3), is_digit);
}

/// "error[MAC303]", at the head of the line or behind the place.
bool holds_finding(std::string_view line) {
    return std::ranges::any_of(severities, [&](std::string_view severity) {
        for (std::size_t at = line.find(severity); at != std::string_view::npos;
             at = line.find(severity, at + 1))
            if ((at == 0 || line.substr(0, at).ends_with(": ")) &&
                begins_with_code(line.substr(at + severity.size())))
                return true;
        return false;
    });
}

/// "::error file=O1.nc,line=4"
bool is_workflow_command(std::string_view line) {
    constexpr std::array<std::string_view, 4> heads = {
        "::error file=", "::warning file=", "::notice file=", "::error title=maclint"};
    return std::ranges::any_of(heads, [&](std::string_view head) { return line.starts_with(head); });
}

/// "maclint: note: O1.txt: this is not linted", where what goes to standard error went into the file, too.
bool is_message(std::string_view line) {
    constexpr std::array<std::string_view, 2> heads = {"maclint: error: ", "maclint: note: "};
    return std::ranges::any_of(heads, [&](std::string_view head) { return line.starts_with(head); });
}

/// "no findings (3 checked)", "no new findings (3 checked)", "1 error in 1 file (3 checked, 1 allowed by
/// comments)"
bool is_summary(std::string_view line) {
    const std::size_t bracket = line.find(" (");
    if (bracket == std::string_view::npos) return false;
    std::string_view rest = line.substr(bracket + 2);
    if (rest.empty() || !is_digit(rest.front())) return false;
    rest.remove_prefix(std::min(rest.size(), rest.find_first_not_of("0123456789")));
    const std::string_view counts = line.substr(0, bracket);
    return rest.starts_with(" checked") && (counts == "no findings" || counts == "no new findings" ||
                                            counts.ends_with(" file") || counts.ends_with(" files"));
}

} // namespace

bool is_own_report(std::string_view text) {
    const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
    return holds_finding(line) || is_workflow_command(line) || is_summary(line) || is_message(line) ||
           line == "findings by rule:";
}

} // namespace maclint::cli
