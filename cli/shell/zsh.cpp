//! The completion script for zsh.
#include "cli/shell/completions.hpp"

namespace maclint::cli {
namespace {

/// zsh ends a description at a bracket, and what stands before a value at a colon.
std::string escaped(const std::string& text, std::string_view special) {
    std::string out;
    for (const char c : text) {
        if (special.find(c) != std::string_view::npos) out += '\\';
        out += c;
    }
    return out;
}

std::string action(const OptionText& option) {
    switch (option.kind) {
    case ValueKind::words: return "(" + joined(option.words) + ")";
    case ValueKind::lists: return "_sequence compadd - " + joined(option.words);
    case ValueKind::path: return "_files";
    case ValueKind::none:
    case ValueKind::free: return " ";
    }
    return " ";
}

std::string value_of(const OptionText& option) {
    return option.kind == ValueKind::none ? "" : ":" + escaped(option.value, ":\\") + ":" + action(option);
}

/// The specifications of one option for _arguments: one a name, which exclude each other.
std::string specification(const OptionText& option) {
    if (option.names.empty())
        return " \\\n            " + quoted((option.repeatable ? "*" : "1") + value_of(option));
    std::string all;
    for (const std::string& name : option.names) {
        std::string one = option.repeatable         ? "*"
                          : option.names.size() > 1 ? "(" + joined(option.names) + ")"
                                                    : "";
        one += name + (option.kind != ValueKind::none && name.starts_with("--") ? "=" : "");
        all +=
            " \\\n            " + quoted(one + "[" + escaped(option.text, "[]\\:") + "]" + value_of(option));
    }
    return all;
}

} // namespace

std::string zsh_completions(const std::vector<CommandText>& commands) {
    std::string script = "#compdef maclint\n"
                         "# Completion of maclint's words for zsh, written by 'maclint completions zsh'.\n"
                         "_maclint() {\n    local command=check\n    local -a commands=(\n";
    for (const CommandText& command : commands)
        script += "        " + quoted(command.name + ":" + command.text) + "\n";
    script += "    )\n    if ((CURRENT > 2)) && [[ ' " + command_names(commands) +
              " ' == *\" $words[2] \"* ]]; then\n"
              "        command=$words[2]\n        shift words\n        ((CURRENT--))\n"
              "    elif ((CURRENT == 2)) && [[ $words[2] != -* ]]; then\n"
              "        _describe command commands\n    fi\n    case $command in\n";
    for (const CommandText& command : commands) {
        script += "        " + command.name + ") _arguments";
        for (const OptionText& option : command.options) script += specification(option);
        script += " ;;\n";
    }
    return script +
           "    esac\n}\n[[ $funcstack[1] == _maclint ]] && _maclint \"$@\" || compdef _maclint maclint\n";
}

} // namespace maclint::cli
