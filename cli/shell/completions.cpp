//! What the scripts for all shells have in common, and the one for bash.
#include "cli/shell/completions.hpp"

namespace maclint::cli {
namespace {

/// "check:--color|rules:--color": what the case statement of the script compares.
std::string pattern(const CommandText& command, const OptionText& option) {
    std::string all;
    for (const std::string& name : option.names) all += (all.empty() ? "" : "|") + command.name + ":" + name;
    return all;
}

std::string offer(const std::string& words) { return "_maclint_offer " + quoted(words) + " \"$word\""; }

/// One row of the case statement: what follows the option.
std::string value_row(const CommandText& command, const OptionText& option) {
    std::string action; // nothing: bash offers files
    if (!option.words.empty())
        action = offer(joined(option.words)) + "; ";
    else if (option.kind == ValueKind::free)
        action = "compopt +o default 2>/dev/null; ";
    return "        " + pattern(command, option) + ") " + action + "return ;;\n";
}

std::string names_of(const CommandText& command) {
    std::vector<std::string> names;
    for (const OptionText& option : command.options)
        names.insert(names.end(), option.names.begin(), option.names.end());
    return joined(names);
}

std::string row_for_options(const CommandText& command) {
    return "        " + command.name + ":-*) " + offer(names_of(command)) + " ;;\n";
}

std::string row_for_operand(const CommandText& command) {
    for (const OptionText& option : command.options)
        if (option.names.empty() && !option.words.empty())
            return "        " + command.name + ":*) " + offer(joined(option.words)) + " ;;\n";
    return "";
}

constexpr const char* bash_head =
    R"(# Completion of maclint's words for bash, written by 'maclint completions bash'.
# Offers those of the words in $1 that go on from $2, behind its last comma.
_maclint_offer() {
    local last=${2##*,}
    COMPREPLY=($(compgen -P "${2%"$last"}" -W "$1" -- "$last"))
}

_maclint() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command=check
    COMPREPLY=()
    # bash takes --format=json for three words
    if [[ $word == = ]]; then word=; elif [[ $before == = ]]; then before=${COMP_WORDS[COMP_CWORD - 2]}; fi
    if ((COMP_CWORD > 1)) && [[ ' @COMMANDS@ ' == *" ${COMP_WORDS[1]} "* ]]; then command=${COMP_WORDS[1]}; fi
    case $command:$before in
)";

} // namespace

std::string quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
}

std::string joined(const std::vector<std::string>& words) {
    std::string all;
    for (const std::string& word : words) all += (all.empty() ? "" : " ") + word;
    return all;
}

std::string command_names(const std::vector<CommandText>& commands) {
    std::vector<std::string> names;
    names.reserve(commands.size());
    for (const CommandText& command : commands) names.push_back(command.name);
    return joined(names);
}

std::string bash_completions(const std::vector<CommandText>& commands) {
    std::string script = bash_head;
    const std::string mark = "@COMMANDS@";
    script.replace(script.find(mark), mark.size(), command_names(commands));
    for (const CommandText& command : commands)
        for (const OptionText& option : command.options)
            if (!option.names.empty() && option.kind != ValueKind::none) script += value_row(command, option);
    script += "    esac\n    case $command:$word in\n";
    for (const CommandText& command : commands) script += row_for_options(command);
    for (const CommandText& command : commands) script += row_for_operand(command);
    script += "        check:*) ((COMP_CWORD > 1)) || " + offer(command_names(commands)) + " ;;\n";
    return script + "    esac\n}\ncomplete -o default -F _maclint maclint\n";
}

} // namespace maclint::cli
