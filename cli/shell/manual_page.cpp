//! Writes the manual page from the declared commands; what stands around them is said here.
#include "cli/shell/manual_page.hpp"

#include "cli/shell/completions.hpp"

#include <algorithm>

namespace maclint::cli {
namespace {

/// Text of a page: a hyphen that is typed, no escape, and no request where a line begins.
std::string plain(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '\\')
            out += "\\e";
        else if (c == '-')
            out += "\\-";
        else if (c == '\'')
            out += "\\(aq";
        else
            out += c;
    }
    return out.starts_with('.') ? "\\&" + out : out;
}

std::string bold(const std::string& text) { return "\\fB" + plain(text) + "\\fR"; }
std::string slanted(const std::string& text) { return "\\fI" + plain(text) + "\\fR"; }

std::string tag(const OptionText& option) {
    std::string all;
    for (const std::string& name : option.names) all += (all.empty() ? "" : ", ") + bold(name);
    if (!option.value.empty()) all += (all.empty() ? "" : " ") + slanted(option.value);
    return all;
}

/// A sentence: the texts of options are written without a full stop.
std::string sentence(const std::string& text) {
    return plain(text) + (text.ends_with('.') || text.empty() ? "" : ".");
}

bool names_all(const OptionText& option) {
    return std::ranges::all_of(
        option.words, [&](const std::string& word) { return option.text.find(word) != std::string::npos; });
}

std::string paragraph(const OptionText& option) {
    std::string all = ".TP\n" + tag(option) + "\n" + sentence(option.text) + "\n";
    // A long list, as that of all rules, has a command of its own.
    if (option.kind == ValueKind::words && option.words.size() < 30 && !names_all(option))
        all += "Known: " + plain(joined(option.words)) + ".\n";
    return all;
}

constexpr const char* before_commands = R"(.SH NAME
maclint \- find mistakes in NC programs before the control does
.SH SYNOPSIS
.B maclint
.RI [ COMMAND ]
.RI [ OPTION .\|.\|.]
.RI [ PATH .\|.\|.]
.SH DESCRIPTION
maclint reads programs in Fanuc Custom Macro B and its relatives, and in HEIDENHAIN DIN PLUS.
It reports what the control would only find with the spindle turning: alarms, endless loops, vacant variables,
modal state left behind, comparisons that rounding breaks.
It needs no network and changes no program.
Without a command it lints, as
.B maclint check
does; without a path, the current folder.
)";

constexpr const char* after_commands = R"(.SH EXIT STATUS
.TP
.B 0
Nothing at or above
.BR \-\-fail\-on .
.TP
.B 1
Findings.
.TP
.B 2
Wrong usage or configuration, or something that could not be read or written.
What could be read is still reported.
.SH ENVIRONMENT
.TP
.B NO_COLOR
No colours, where
.B \-\-color
does not ask for them.
.SH FILES
.TP
.I .maclint.json
The configuration: the nearest one upward from each file holds.
.SH EXAMPLES
Lint a folder:
.PP
.RS
maclint programs
.RE
.PP
A report for a code scanner, which does not stop a pipeline:
.PP
.RS
maclint \-\-output sarif:maclint.sarif \-\-fail\-on never .
.RE
.PP
Why a rule exists, with examples:
.PP
.RS
maclint explain MAC303
.RE
)";

} // namespace

std::string manual_page(const std::vector<CommandText>& commands, std::string_view version) {
    std::string page =
        ".TH MACLINT 1 \"\" \"maclint " + std::string(version) + "\" \"User Commands\"\n" + before_commands;
    page += ".SH COMMANDS\n";
    for (const CommandText& command : commands) {
        page += ".SS maclint " + plain(command.name) + "\n" + sentence(command.text) + "\n";
        for (const OptionText& option : command.options) page += paragraph(option);
    }
    return page + after_commands;
}

} // namespace maclint::cli
