//! Finds the command and reads its options.
#include "cli/command_line.hpp"

#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "cli/options/check_options.hpp"
#include "cli/options/choices.hpp"
#include "cli/shell/completions.hpp"
#include "cli/shell/describe.hpp"
#include "cli/shell/manual_page.hpp"
#include "cli/suggest.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <thread>

#include <CLI/CLI.hpp>

namespace maclint::cli {
namespace {

constexpr std::array<std::string_view, 7> commands = {"check", "rules", "explain", "completions",
                                                      "man",   "help",  "version"};
constexpr std::string_view version_text = "maclint " MACLINT_VERSION "\n";

using ShellScript = std::string (*)(const std::vector<CommandText>&);
constexpr std::array<Choice<ShellScript>, 3> shells{
    {{"bash", bash_completions}, {"zsh", zsh_completions}, {"fish", fish_completions}}};

void declare_common(CLI::App& app) {
    app.set_help_flag("--help,-h", "This text");
    app.set_version_flag("--version,-V", std::string(version_text), "The version");
}

/// What CLI11 took for more than it knows: `--`, after which it takes no options, is among it.
void refuse_unknown(const CLI::App& app) {
    bool options_end = false;
    for (const std::string& word : app.remaining()) {
        if (word == "--" && !std::exchange(options_end, true)) continue;
        std::vector<std::string> known;
        for (const CLI::Option* option : app.get_options())
            if (!option->get_lnames().empty()) known.push_back("--" + option->get_lnames().front());
        const std::string name = word.substr(0, word.find('='));
        if (word.starts_with('-') && word != "-" && !options_end)
            refuse("there is no option '" + name + "'." +
                   did_you_mean(name, known, "See 'maclint " + app.get_name() + " --help'."));
        refuse("there is one word too many: '" + word + "'. Leave it out.");
    }
}

void parse(CLI::App& app, std::vector<std::string> arguments) {
    app.allow_extras();
    app.allow_windows_style_options(false); // "/shop/O1.nc" is a path there, too
    std::ranges::reverse(arguments);        // CLI11 takes words from the back
    try {
        app.parse(std::move(arguments));
    } catch (const CLI::CallForHelp&) {
        throw Refused{};
    } catch (const CLI::CallForVersion&) {
        throw PrintRequest{std::string(version_text)};
    } catch (const CLI::ParseError& error) {
        refuse(std::string(error.what()) + ". See 'maclint " + app.get_name() + " --help'.");
    }
    refuse_unknown(app);
}

/// The text to print when help was asked for.
std::optional<PrintRequest> parse_or_help(CLI::App& app, std::vector<std::string> arguments) {
    try {
        parse(app, std::move(arguments));
    } catch (const Refused& refused) {
        if (refused.message.empty()) return PrintRequest{app.help("maclint")};
        throw;
    }
    return std::nullopt;
}

/// A path that does not exist but looks like a command was meant as one.
void suggest_command(const std::vector<std::string>& paths) {
    if (paths.empty() || paths.front() == "-" ||
        platform::kind_of(platform::path_of(paths.front())) != platform::FileKind::missing)
        return;
    const std::vector<std::string> known(commands.begin(), commands.end());
    if (const auto command = closest(paths.front(), known))
        refuse("'" + shown(paths.front()) + "' is neither a command nor a file. Did you mean 'maclint " +
               *command + "'?");
}

std::string overview(CLI::App& check) {
    check.name("[check]");
    return "maclint finds in NC programs what the control would only find with the spindle turning.\n\n"
           "Commands:\n"
           "  maclint [check] [PATH...]   lint files and folders\n"
           "  maclint rules               the list of rules\n"
           "  maclint explain RULE        a rule's page\n"
           "  maclint completions SHELL   what bash, zsh or fish need to complete maclint's words\n"
           "  maclint man                 the manual page\n"
           "  maclint help [COMMAND]      this text, or that of a command\n"
           "  maclint version             the version\n\n" +
           check.help("maclint") +
           "\nExit status: 0 nothing at or above --fail-on, 1 findings, 2 wrong usage, configuration or "
           "input.\n";
}

Request read_check(std::vector<std::string> arguments, bool with_overview) {
    CLI::App app("", "check");
    CheckWords words;
    declare_common(app);
    declare_check(app, words);
    if (with_overview) return PrintRequest{overview(app)};
    try {
        parse(app, std::move(arguments));
    } catch (const Refused& refused) {
        if (refused.message.empty()) return PrintRequest{overview(app)};
        throw;
    }
    suggest_command(words.paths);
    return check_request(words);
}

void declare_rules(CLI::App& app, std::string& format, std::string& docs_folder) {
    app.add_option("--format", format, "text, json or markdown")->type_name("FORMAT");
    app.add_option("--write-docs", docs_folder, "Write one page a rule and an index into this folder")
        ->type_name("DIR");
}

void declare_explain(CLI::App& app, std::string& rule, std::string& colour) {
    app.add_option("RULE", rule, "Code or name, in any case, or a part of it")->type_name("");
    app.add_option("--color", colour, "auto, always or never; NO_COLOR is respected")->type_name("WHEN");
}

void declare_completions(CLI::App& app, std::string& shell) {
    app.add_option("SHELL", shell, "bash, zsh or fish")->type_name("");
}

void declare_help(CLI::App& app, std::string& command) {
    app.add_option("COMMAND", command, "The command that they are of")->type_name("");
}

Request read_rules(std::vector<std::string> arguments) {
    CLI::App app("The list of rules.", "rules");
    std::string format = "text";
    RulesRequest request;
    declare_common(app);
    declare_rules(app, format, request.docs_folder);
    if (const auto help = parse_or_help(app, std::move(arguments))) return *help;
    request.format = choose("--format", format, list_formats);
    return request;
}

Request read_explain(std::vector<std::string> arguments) {
    CLI::App app("A rule's page.", "explain");
    ExplainRequest request;
    declare_common(app);
    std::string colour = "auto";
    declare_explain(app, request.rule, colour);
    if (const auto help = parse_or_help(app, std::move(arguments))) return *help;
    request.colour = choose("--color", colour, colours);
    if (request.rule.empty())
        refuse("explain needs a rule. Write 'maclint explain MAC303', or see 'maclint rules'.");
    return request;
}

/// Options of all commands that take one of a few words; the others take any.
std::vector<std::string> known_words(std::string_view command, std::string_view option) {
    if (option == "--format") return command == "rules" ? words_of(list_formats) : words_of(formats);
    if (option == "--dialect") {
        auto names = dialect_names();
        names.insert(names.begin(), "auto");
        return names;
    }
    if (option == "--control") return control_names();
    if (option == "--fail-on") return {"error", "warning", "note", "never"};
    if (option == "--path") return words_of(path_details);
    if (option == "--color") return words_of(colours);
    if (option == "--select" || option == "--ignore" || option == "RULE") return rule_words();
    if (option == "SHELL") return words_of(shells);
    if (option == "COMMAND") return {commands.begin(), commands.end()};
    return {};
}

/// One command as it is declared; `declare` is given the application and does that.
template<class Declare>
CommandText described(const std::string& name, std::string text, Declare declare) {
    CLI::App app("", name);
    declare_common(app);
    declare(app);
    return describe(app, std::move(text),
                    [&name](std::string_view option) { return known_words(name, option); });
}

Request read_completions(std::vector<std::string> arguments) {
    CLI::App app("A script on standard output that lets a shell complete maclint's words.", "completions");
    declare_common(app);
    std::string shell;
    declare_completions(app, shell);
    if (const auto help = parse_or_help(app, std::move(arguments))) return *help;
    if (shell.empty()) refuse("completions needs a shell. Write 'maclint completions bash', zsh or fish.");
    return PrintRequest{choose("completions", shell, shells)(command_list())};
}

Request read_man(std::vector<std::string> arguments) {
    CLI::App app("The manual page on standard output, as 'man' reads it.", "man");
    declare_common(app);
    if (const auto help = parse_or_help(app, std::move(arguments))) return *help;
    return PrintRequest{manual_page(command_list(), MACLINT_VERSION)};
}

Request read_version(std::vector<std::string> arguments) {
    CLI::App app("The version on standard output.", "version");
    declare_common(app);
    if (const auto help = parse_or_help(app, std::move(arguments))) return *help;
    return PrintRequest{std::string(version_text)};
}

/// `help rules` is `rules --help`.
Request read_help(std::vector<std::string> arguments) {
    CLI::App app("The options of a command.", "help");
    declare_common(app);
    std::string about = "check";
    declare_help(app, about);
    if (const auto help = parse_or_help(app, std::move(arguments))) return *help;
    if (about == "check") return read_check({}, true);
    if (about == "rules") return read_rules({"--help"});
    if (about == "explain") return read_explain({"--help"});
    if (about == "completions") return read_completions({"--help"});
    if (about == "man") return read_man({"--help"});
    if (about == "version") return read_version({"--help"});
    if (about == "help") return read_help({"--help"});
    if (!rules_named(about).empty())
        refuse("help knows commands, not rules. Did you mean 'maclint explain " + about + "'?");
    const std::vector<std::string> known(commands.begin(), commands.end());
    refuse_word("help", about, known);
}

} // namespace

std::vector<CommandText> command_list() {
    CheckWords words;
    std::string text;
    return {
        described("check", "Lint files and folders", [&](CLI::App& app) { declare_check(app, words); }),
        described("rules", "List the rules", [&](CLI::App& app) { declare_rules(app, text, text); }),
        described("explain", "Show a rule's page", [&](CLI::App& app) { declare_explain(app, text, text); }),
        described("completions", "Print what a shell needs to complete maclint's words",
                  [&](CLI::App& app) { declare_completions(app, text); }),
        described("man", "Print the manual page", [](CLI::App&) {}),
        described("help", "Show the options", [&](CLI::App& app) { declare_help(app, text); }),
        described("version", "Print the version", [](CLI::App&) {})};
}

Request read_command_line(std::vector<std::string> arguments) {
    const std::string first = arguments.empty() ? "" : arguments.front();
    const bool is_command = std::ranges::find(commands, first) != commands.end();
    if (is_command) arguments.erase(arguments.begin());
    try {
        if (first == "rules") return read_rules(std::move(arguments));
        if (first == "explain") return read_explain(std::move(arguments));
        if (first == "completions") return read_completions(std::move(arguments));
        if (first == "man") return read_man(std::move(arguments));
        if (first == "help") return read_help(std::move(arguments));
        if (first == "version") return read_version(std::move(arguments));
        return read_check(std::move(arguments), first == "--help" || first == "-h");
    } catch (const Refused& refused) {
        return UsageError{refused.message};
    } catch (const PrintRequest& print) {
        return print;
    }
}

} // namespace maclint::cli
