//! Finds the command in a table and reads its options.
#include "cli/command_line.hpp"

#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "cli/options/check_options.hpp"
#include "cli/options/choices.hpp"
#include "cli/options/help.hpp"
#include "cli/shell/completions.hpp"
#include "cli/shell/describe.hpp"
#include "cli/shell/manual_page.hpp"
#include "cli/terminal.hpp"
#include "cli/text/guess.hpp"
#include "cli/text/letters.hpp"
#include "cli/text/shown.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>

#include <CLI/CLI.hpp>

namespace maclint::cli {
namespace {

constexpr std::string_view version_text = "maclint " MACLINT_VERSION "\n";

using ShellScript = std::string (*)(const std::vector<CommandText>&);
constexpr std::array<Choice<ShellScript>, 3> shells{
    {{"bash", bash_completions}, {"zsh", zsh_completions}, {"fish", fish_completions}}};

/// What was typed behind a command, each of which has its own.
struct Words {
    CheckWords check;
    std::string format = "text", docs_folder, codes_folder, alarms_file, rule, dialect = "auto", control,
                colour = "auto", shell, about = "check", folder = ".", start, step, jobs;
    std::vector<std::string> files;
    bool print = false, diff = false, stdio = false;
};

struct Command {
    std::string_view name;
    std::string_view operands; ///< as they are written behind it
    std::string_view text;     ///< what it does
    std::string_view heading;  ///< of its help
    void (*declare)(CLI::App& app, Words& words);
    Request (*request)(const Words& words);
    std::span<const HelpExample> examples = {};
};

std::span<const Command> commands();

const Command* find_command(std::string_view name) {
    const auto found = std::ranges::find(commands(), name, &Command::name);
    return found == commands().end() ? nullptr : &*found;
}

std::vector<std::string> command_names() {
    std::vector<std::string> names;
    for (const Command& command : commands()) names.emplace_back(command.name);
    return names;
}

void declare_common(CLI::App& app) {
    app.option_defaults()->group("Options");
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

[[noreturn]] void refuse_empty(const std::string& option) {
    refuse(option +
           " has an empty value, as from a variable that nobody has set. Write one, or leave the option "
           "out.");
}

/// `--since=` with nothing behind it: CLI11 would take the next word for the value.
void refuse_empty_values(const CLI::App& app, const std::vector<std::string>& words) {
    for (const std::string& word : words) {
        if (word == "--") return;
        if (!word.starts_with("--") || !word.ends_with('=')) continue;
        const std::string name = word.substr(0, word.size() - 1);
        const CLI::Option* option = app.get_option_no_throw(name);
        if (option == nullptr) continue;
        if (option->get_items_expected_min() > 0) refuse_empty(name);
        refuse(name + " takes no value. Leave '=' out.");
    }
}

/// `--since ''`. An empty path is told of like other paths that lead nowhere.
void refuse_empty_values(const CLI::App& app) {
    for (const CLI::Option* option : app.get_options())
        if (!option->get_positional() && option->get_items_expected_min() > 0 &&
            std::ranges::find(option->results(), "") != option->results().end())
            refuse_empty(option->get_name());
}

std::string usage_of(const Command& command) {
    const std::string name = command.name == "check" ? "[check]" : std::string(command.name);
    return "maclint " + name + " [OPTIONS]" + (command.operands.empty() ? "" : " ") +
           std::string(command.operands);
}

/// What stands above the options of `check`, which is meant where no command is named.
std::string overview(std::size_t width) {
    std::vector<HelpCommand> list;
    for (const Command& command : commands()) {
        const std::string name = command.name == "check" ? "[check]" : std::string(command.name);
        list.push_back(
            {"maclint " + name + (command.operands.empty() ? "" : " ") + std::string(command.operands),
             in_lower_case(command.text.substr(0, 1)) + std::string(command.text.substr(1))});
    }
    return paragraph("maclint finds in NC programs what the control would only find with the spindle "
                     "turning. It reads FANUC and its relatives, HEIDENHAIN DIN PLUS, and SIEMENS "
                     "SINUMERIK.",
                     width) +
           "\n" + help_of(list, width) + "\n";
}

std::string help_of(const Command& command, const CLI::App& app) {
    const std::size_t width = output_width();
    std::string text = command.name == "check" ? overview(width) : "";
    text += help_of(app, usage_of(command), command.examples, width);
    return text + (command.name != "check"
                       ? ""
                       : "\n" + paragraph("Exit status: 0 nothing at or above --fail-on, 1 findings, 2 wrong "
                                          "usage, configuration or input.",
                                          width));
}

/// What is to be printed in place of what the command does, where that was asked for.
std::optional<PrintRequest> parse(const Command& command, CLI::App& app, std::vector<std::string> arguments) {
    app.allow_extras();
    app.allow_windows_style_options(false); // "/shop/O1.nc" is a path there, too
    refuse_empty_values(app, arguments);
    std::ranges::reverse(arguments); // CLI11 takes words from the back
    try {
        app.parse(std::move(arguments));
    } catch (const CLI::CallForHelp&) {
        return PrintRequest{help_of(command, app)};
    } catch (const CLI::CallForVersion&) {
        return PrintRequest{std::string(version_text)};
    } catch (const CLI::ParseError& error) {
        refuse(std::string(error.what()) + ". See 'maclint " + app.get_name() + " --help'.");
    }
    refuse_unknown(app);
    refuse_empty_values(app);
    return std::nullopt;
}

Request read(const Command& command, std::vector<std::string> arguments) {
    CLI::App app(std::string(command.heading), std::string(command.name));
    Words words;
    command.declare(app, words);
    declare_common(app);
    if (auto print = parse(command, app, std::move(arguments))) return *std::move(print);
    return command.request(words);
}

/// A path that does not exist but looks like a command was meant as one.
void suggest_command(const std::vector<std::string>& paths) {
    if (paths.empty() || paths.front() == "-" ||
        platform::kind_of(platform::path_of(paths.front())) != platform::FileKind::missing)
        return;
    if (const auto command = closest(paths.front(), command_names()))
        refuse("'" + shown(paths.front()) + "' is neither a command nor a file. Did you mean 'maclint " +
               *command + "'?");
}

void declare_check_command(CLI::App& app, Words& words) { declare_check(app, words.check); }

Request check_command(const Words& words) {
    suggest_command(words.check.paths);
    return check_request(words.check);
}

void declare_rules(CLI::App& app, Words& words) {
    app.add_option("--format", words.format, "text, json or markdown")->type_name("FORMAT");
    app.add_option("--write-docs", words.docs_folder, "Write one page a rule and an index into this folder")
        ->type_name("DIR");
    app.add_option("--write-codes", words.codes_folder,
                   "Write what is known of each code, a folder a language, into this folder")
        ->type_name("DIR");
    app.add_option("--write-alarms", words.alarms_file,
                   "Write the alarms of controls, with the rules that find them, into this file")
        ->type_name("FILE");
}

Request rules_request(const Words& words) {
    return RulesRequest{choose("--format", words.format, list_formats), words.docs_folder, words.codes_folder,
                        words.alarms_file};
}

void declare_explain(CLI::App& app, Words& words) {
    app.add_option("RULE", words.rule,
                   "Code or name, in any case, with the key of a row or without, or a part of it; or a code "
                   "of programs, such as G83, a variable, such as '#4109', or the number of an alarm")
        ->type_name("");
    app.add_option("--dialect", words.dialect, "Of a code such as G83: in this language alone")
        ->type_name("NAME");
    app.add_option("--control", words.control, "Of a code, a variable or an alarm: on this control alone")
        ->type_name("NAME");
    app.add_option("--format", words.format, "text or json")->type_name("FORMAT");
    app.add_option("--color", words.colour, "auto, always or never; NO_COLOR is respected")
        ->type_name("WHEN");
}

Request explain_request(const Words& words) {
    const ColourChoice colour = choose("--color", words.colour, colours);
    if (words.rule.empty())
        refuse("explain needs a rule. Write 'maclint explain MAC303', or see 'maclint rules'.");
    const Dialect* dialect = find_dialect(words.dialect);
    if (dialect == nullptr && words.dialect != "auto")
        refuse_word("--dialect", words.dialect, dialect_words());
    const ControlModel* control = words.control.empty() ? nullptr : find_control(words.control);
    if (control == nullptr && !words.control.empty())
        refuse_word("--control", words.control, control_names());
    return ExplainRequest{words.rule, colour, dialect, control,
                          choose("--format", words.format, plain_list_formats)};
}

void declare_controls(CLI::App& app, Words& words) {
    app.add_option("NAME", words.control, "All that is known of this one")->type_name("");
    app.add_option("--format", words.format, "text or json")->type_name("FORMAT");
    app.add_option("--color", words.colour, "auto, always or never; NO_COLOR is respected")
        ->type_name("WHEN");
}

Request controls_request(const Words& words) {
    const ControlModel* control = words.control.empty() ? nullptr : find_control(words.control);
    if (control == nullptr && !words.control.empty()) refuse_word("controls", words.control, control_names());
    return ControlsRequest{choose("--format", words.format, plain_list_formats), control,
                           choose("--color", words.colour, colours)};
}

void declare_init(CLI::App& app, Words& words) {
    app.add_option("FOLDER", words.folder, "The folder that the programs lie in (default: .)")->type_name("");
    app.add_flag("--print", words.print, "Show what would be written, and write nothing");
}

Request init_request(const Words& words) { return InitRequest{words.folder, words.print}; }

void declare_renumber(CLI::App& app, Words& words) {
    app.add_option("FILE", words.files, "Programs; each is numbered for itself")->type_name("");
    app.add_option("--start", words.start, "Number of the first block (default: 10)")->type_name("N");
    app.add_option("--step", words.step, "From one number to the next (default: 10)")->type_name("N");
    app.add_flag("--diff", words.diff, "Print what would change, and change nothing");
    app.add_option("--dialect", words.dialect, "Language of the programs, where they do not show it")
        ->type_name("NAME");
    app.add_option("--control", words.control, "Control that the programs are for")->type_name("NAME");
}

Request renumber_request(const Words& words) {
    constexpr std::int64_t most = 99999;
    if (words.files.empty()) refuse("renumber needs a program. Write 'maclint renumber O9100.nc'.");
    RenumberRequest request;
    request.paths = words.files;
    request.diff = words.diff;
    if (std::ranges::find(words.files, "-") != words.files.end())
        refuse("renumber does not take standard input. Name the file.");
    request.overrides.dialect = find_dialect(words.dialect);
    if (request.overrides.dialect == nullptr && words.dialect != "auto")
        refuse_word("--dialect", words.dialect, dialect_words());
    if (!words.control.empty() && find_control(words.control) == nullptr)
        refuse_word("--control", words.control, control_names());
    request.overrides.control = words.control;
    if (!words.start.empty()) request.numbering.start = number<std::int64_t>("--start", words.start, 1, most);
    if (!words.step.empty()) request.numbering.step = number<std::int64_t>("--step", words.step, 1, most);
    return request;
}

void declare_lsp(CLI::App& app, Words& words) {
    app.add_flag("--stdio", words.stdio, "What it does anyhow, for editors that say so");
    app.add_option("--jobs", words.jobs, "Threads (default: one a core)")->type_name("N");
}

Request lsp_request(const Words& words) { return LspRequest{jobs_in(words.jobs)}; }

void declare_completions(CLI::App& app, Words& words) {
    app.add_option("SHELL", words.shell, "bash, zsh or fish")->type_name("");
}

Request completions_request(const Words& words) {
    if (words.shell.empty())
        refuse("completions needs a shell. Write 'maclint completions bash', zsh or fish.");
    return PrintRequest{choose("completions", words.shell, shells)(command_list())};
}

void declare_nothing(CLI::App&, Words&) {}

Request man_request(const Words&) { return PrintRequest{manual_page(command_list(), MACLINT_VERSION)}; }

void declare_help(CLI::App& app, Words& words) {
    app.add_option("COMMAND", words.about, "The command that they are of")->type_name("");
}

/// `help rules` is `rules --help`.
Request help_request(const Words& words) {
    if (const Command* command = find_command(words.about)) return read(*command, {"--help"});
    if (!rules_named(words.about).empty())
        refuse("help knows commands, not rules. Did you mean 'maclint explain " + words.about + "'?");
    refuse_word("help", words.about, command_names());
}

Request version_request(const Words&) { return PrintRequest{std::string(version_text)}; }

constexpr std::array<HelpExample, 5> check_examples{
    {{"maclint", "Check all programs in this folder and below."},
     {"maclint O9100.nc --control fanuc-30i", "One program, for one control."},
     {"maclint --diff programs", "Show what 'maclint --fix programs' would correct."},
     {"maclint --write-baseline known.json .",
      "Note what is found now; with --baseline known.json only what is new counts."},
     {"maclint --output sarif:maclint.sarif --fail-on never .", "Also write a report for a service."}}};
constexpr std::array<HelpExample, 2> rules_examples{
    {{"maclint rules", "The list for reading."},
     {"maclint rules --format json", "The same for programs, with what each rule is good for."}}};
constexpr std::array<HelpExample, 4> explain_examples{
    {{"maclint explain MAC303",
      "A rule by its code; 'maclint explain jump' lists those that have to do with jumps."},
     {"maclint explain G83 --control fanuc-16i", "A code and its words on one control."},
     {"maclint explain '#4109'", "A variable, in quotes, which most shells want."},
     {"maclint explain PS0128", "An alarm by its number."}}};
constexpr std::array<HelpExample, 1> controls_examples{
    {{"maclint controls fanuc-30i", "Its codes, limits, variables and options."}}};
constexpr std::array<HelpExample, 2> init_examples{
    {{"maclint init --print", "What would be written for this folder, and why."},
     {"maclint init programs", "Write programs/.maclint.json. One that is there is never changed."}}};
constexpr std::array<HelpExample, 2> renumber_examples{
    {{"maclint renumber --diff O9100.nc", "What would change: numbers of blocks, jumps, P and Q of cycles."},
     {"maclint renumber O9100.nc --start 100 --step 5", "N100, N105, N110 and so on."}}};
constexpr std::array<HelpExample, 1> lsp_examples{
    {{"maclint lsp", "What editors start; docs/lsp.md says how they are told."}}};
constexpr std::array<HelpExample, 1> completions_examples{
    {{"maclint completions bash > ~/.local/share/bash-completion/completions/maclint",
      "Where bash looks for them."}}};

std::span<const Command> commands() {
    static constexpr std::array<Command, 11> all{
        {{"check", "[PATH...]", "Lint files and folders", "", declare_check_command, check_command,
          check_examples},
         {"rules", "", "List the rules", "The list of rules.", declare_rules, rules_request, rules_examples},
         {"explain", "RULE", "Show the page of a rule, a code, a word of a language, a variable or an alarm",
          "The page of a rule, a code, a variable or an alarm.", declare_explain, explain_request,
          explain_examples},
         {"controls", "[NAME]", "List the controls, and what is known of each",
          "The controls, and what is known of each.", declare_controls, controls_request, controls_examples},
         {"init", "[FOLDER]", "Write a configuration for a folder, with comments that say why",
          "Looks at the programs of a folder and writes a .maclint.json with what they are taken for.",
          declare_init, init_request, init_examples},
         {"renumber", "FILE...", "Number the blocks of programs anew, with all that names them",
          "Numbers the blocks that have a number, with jumps, returns and cycles that name them; comments "
          "and all else stay. A program in which that is not safe is left as it is.",
          declare_renumber, renumber_request, renumber_examples},
         {"lsp", "", "Serve editors: findings while typing, fixes, definitions, symbols",
          "A language server (LSP 3.17) that editors start and talk to over standard input and output.",
          declare_lsp, lsp_request, lsp_examples},
         {"completions", "SHELL", "Print what bash, zsh or fish need to complete maclint's words",
          "A script on standard output that lets a shell complete maclint's words.", declare_completions,
          completions_request, completions_examples},
         {"man", "", "Print the manual page", "The manual page on standard output, as 'man' reads it.",
          declare_nothing, man_request},
         {"help", "[COMMAND]", "Show the options of a command", "The options of a command.", declare_help,
          help_request},
         {"version", "", "Print the version", "The version on standard output.", declare_nothing,
          version_request}}};
    return all;
}

/// Options of all commands that take one of a few words; the others take any.
std::vector<std::string> known_words(std::string_view command, std::string_view option) {
    if (option == "--format" && (command == "controls" || command == "explain"))
        return words_of(plain_list_formats);
    if (option == "--format") return command == "rules" ? words_of(list_formats) : words_of(formats);
    if (option == "--dialect") return dialect_words();
    if (option == "--control" || option == "NAME") return control_names();
    if (option == "--fail-on") return fail_on_words();
    if (option == "--path") return words_of(path_details);
    if (option == "--color") return words_of(colours);
    if (option == "--without-exemption") return exemption_words();
    if (option == "--select" || option == "--ignore" || option == "RULE") return rule_words();
    if (option == "SHELL") return words_of(shells);
    if (option == "COMMAND") return command_names();
    return {};
}

} // namespace

std::vector<CommandText> command_list() {
    std::vector<CommandText> list;
    for (const Command& command : commands()) {
        CLI::App app("", std::string(command.name));
        Words words;
        command.declare(app, words);
        declare_common(app);
        list.push_back(describe(app, std::string(command.text),
                                [&](std::string_view option) { return known_words(command.name, option); }));
    }
    return list;
}

Request read_command_line(std::vector<std::string> arguments) {
    const Command* command = arguments.empty() ? nullptr : find_command(arguments.front());
    if (command != nullptr) arguments.erase(arguments.begin());
    try {
        return read(command == nullptr ? commands().front() : *command, std::move(arguments));
    } catch (const Refused& refused) {
        return UsageError{refused.message};
    }
}

} // namespace maclint::cli
