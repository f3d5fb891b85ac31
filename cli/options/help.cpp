//! Two columns: what is typed, and what it does, which begins on the next line where the first is too wide.
#include "cli/options/help.hpp"

#include "cli/report/columns.hpp"
#include "cli/text/letters.hpp"

#include <algorithm>

#include <CLI/CLI.hpp>

namespace maclint::cli {
namespace {

constexpr std::size_t indent = 2;
constexpr std::size_t widest_left = 26; ///< columns of what is typed, beside which its text still stands
constexpr std::string_view last_group = "Options"; ///< CLI11's own, of --help and --version

std::string entry(const std::string& left, std::string_view right, std::size_t width) {
    constexpr std::size_t column = indent + widest_left + 1;
    const std::size_t room = width - std::min(column, width / 2);
    std::string out = std::string(indent, ' ') + left;
    const auto lines = wrapped(right, room, room);
    if (left.size() > widest_left)
        out += "\n" + std::string(column, ' ');
    else
        out.resize(column, ' ');
    out += lines.front() + "\n";
    for (auto line = lines.begin() + 1; line != lines.end(); ++line)
        out += std::string(column, ' ') + *line + "\n";
    return out;
}

/// "-q, --quiet", "--format FORMAT", "PATH".
std::string typed(const CLI::Option& option) {
    if (option.get_positional()) return option.get_name(true);
    std::string names;
    for (const std::string& name : option.get_snames()) names.append("-").append(name).append(", ");
    for (const std::string& name : option.get_lnames()) names.append("--").append(name).append(", ");
    names.resize(names.size() - 2);
    return option.get_items_expected_min() > 0 ? names + " " + option.get_type_name() : names;
}

/// That of an option, however the version of CLI11 writes its own.
std::string group_of(const CLI::Option& option) {
    const std::string& group = option.get_group();
    return in_lower_case(group) == in_lower_case(last_group) ? std::string(last_group) : group;
}

/// In the order in which they were declared, the last one last.
std::vector<std::string> groups_of(const std::vector<const CLI::Option*>& options) {
    std::vector<std::string> groups;
    for (const CLI::Option* option : options)
        if (!option->get_positional() && group_of(*option) != last_group &&
            std::ranges::find(groups, group_of(*option)) == groups.end())
            groups.push_back(group_of(*option));
    groups.emplace_back(last_group);
    return groups;
}

} // namespace

std::string help_of(const CLI::App& app, std::string_view usage, std::span<const HelpExample> examples,
                    std::size_t width) {
    std::string out = app.get_description().empty() ? "" : paragraph(app.get_description(), width) + "\n";
    out += paragraph("Usage: " + std::string(usage), width);
    const std::vector<const CLI::Option*> options = app.get_options();
    bool has_operands = false;
    for (const CLI::Option* option : options)
        if (option->get_positional()) {
            out += (has_operands ? "" : "\n") + entry(typed(*option), option->get_description(), width);
            has_operands = true;
        }
    for (const std::string& group : groups_of(options)) {
        out += "\n" + group + ":\n";
        for (const CLI::Option* option : options)
            if (!option->get_positional() && group_of(*option) == group)
                out += entry(typed(*option), option->get_description(), width);
    }
    if (!examples.empty()) out += "\nExamples:\n";
    for (const HelpExample& example : examples) {
        out += std::string(indent, ' ') + std::string(example.command) + "\n";
        for (const std::string& line : wrapped(example.what, width - 2 * indent, width - 2 * indent))
            out += std::string(2 * indent, ' ') + line + "\n";
    }
    return out;
}

std::string help_of(const std::vector<HelpCommand>& commands, std::size_t width) {
    std::string out = "Commands:\n";
    for (const HelpCommand& command : commands) out += entry(command.command, command.what, width);
    return out;
}

std::string paragraph(std::string_view text, std::size_t width) {
    std::string out;
    for (const std::string& line : wrapped(text, width, width)) out += line + "\n";
    return out;
}

} // namespace maclint::cli
