//! The completion script for fish.
#include "cli/shell/completions.hpp"

namespace maclint::cli {
namespace {

std::string fish_quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) {
        if (c == '\'' || c == '\\') out += '\\';
        out += c;
    }
    return out + "'";
}

std::string offered(const OptionText& option) {
    switch (option.kind) {
    case ValueKind::none: return "";
    case ValueKind::path: return " -r";
    case ValueKind::free: return " -x";
    case ValueKind::lists:
        // fish completes the last part of a list when it is told how the list is divided
        return " -x -a \"(__fish_complete_list , 'printf \\'%s\\\\n\\' " + joined(option.words) + "')\"";
    case ValueKind::words: return " -x -a " + fish_quoted(joined(option.words));
    }
    return "";
}

std::string row(const CommandText& command, const OptionText& option) {
    std::string line = "complete -c maclint -n 'test (__maclint_command) = " + command.name + "'";
    if (option.names.empty())
        return option.words.empty() ? "" : line + " -f -a " + fish_quoted(joined(option.words)) + "\n";
    for (const std::string& name : option.names)
        line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    return line + offered(option) + " -d " + fish_quoted(option.text) + "\n";
}

} // namespace

std::string fish_completions(const std::vector<CommandText>& commands) {
    std::string script = "# Completion of maclint's words for fish, written by 'maclint completions fish'.\n"
                         "function __maclint_command\n"
                         "    set -l words (commandline -opc)\n"
                         "    if set -q words[2]; and contains -- $words[2] " +
                         command_names(commands) +
                         "\n        echo $words[2]\n    else\n        echo check\n    end\nend\n";
    for (const CommandText& command : commands)
        script += "complete -c maclint -n 'test (count (commandline -opc)) -eq 1' -a " + command.name +
                  " -d " + fish_quoted(command.text) + "\n";
    for (const CommandText& command : commands)
        for (const OptionText& option : command.options) script += row(command, option);
    return script;
}

} // namespace maclint::cli
