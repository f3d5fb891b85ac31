//! Options are declared to CLI11 as texts; what they may say is checked here, so that the answer can be a
//! good one.
#include "cli/command_line.hpp"

#include "analyzer/source/platform/console.hpp"
#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "cli/input/wildcards.hpp"
#include "cli/suggest.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <thread>

#include <CLI/CLI.hpp>

namespace maclint::cli {
namespace {

constexpr std::array<std::string_view, 3> commands = {"check", "rules", "explain"};
constexpr std::string_view default_stdin_name = "stdin.nc";
constexpr unsigned most_jobs = 1024;

template<class Value>
struct Choice {
    std::string_view word;
    Value value;
};

constexpr std::array<Choice<Format>, 4> formats{
    {{"text", Format::text}, {"concise", Format::concise}, {"json", Format::json}, {"sarif", Format::sarif}}};
constexpr std::array<Choice<ListFormat>, 3> list_formats{
    {{"text", ListFormat::text}, {"json", ListFormat::json}, {"markdown", ListFormat::markdown}}};
constexpr std::array<Choice<ColourChoice>, 3> colours{
    {{"auto", ColourChoice::automatic}, {"always", ColourChoice::always}, {"never", ColourChoice::never}}};
constexpr std::array<Choice<PathDetail>, 3> path_details{
    {{"full", PathDetail::full}, {"short", PathDetail::shortened}, {"none", PathDetail::none}}};

/// Thrown while texts are made into values, caught in read_command_line.
struct Refused {
    UsageError error;
};

[[noreturn]] void refuse(std::string message) { throw Refused{{std::move(message)}}; }

[[noreturn]] void refuse_word(std::string_view option, const std::string& word,
                              const std::vector<std::string>& known) {
    refuse(std::string(option) + " does not know '" + word + "'." +
           did_you_mean(word, known, "Known are " + enumerate(known) + "."));
}

template<class Choices>
auto choose(std::string_view option, const std::string& word, const Choices& choices) {
    for (const auto& choice : choices)
        if (choice.word == word) return choice.value;
    std::vector<std::string> known;
    for (const auto& choice : choices) known.emplace_back(choice.word);
    refuse_word(option, word, known);
}

template<class Number>
Number number(std::string_view option, const std::string& word, Number least, Number most) {
    Number value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size() || value < least || value > most)
        refuse(std::string(option) + " does not take '" + word + "'. Give a whole number from " +
               std::to_string(least) + " to " + std::to_string(most) + ".");
    return value;
}

std::vector<std::string> split_at_commas(const std::vector<std::string>& lists) {
    std::vector<std::string> words;
    for (std::string_view list : lists) {
        while (!list.empty()) {
            const auto word = list.substr(0, list.find(','));
            if (!word.empty()) words.emplace_back(word);
            list.remove_prefix(word.size() == list.size() ? word.size() : word.size() + 1);
        }
    }
    return words;
}

void require_rules(std::string_view option, const std::vector<std::string>& words) {
    for (const std::string& word : words)
        if (rules_named(word).empty())
            refuse(std::string(option) + " names no rule: '" + word + "'." +
                   did_you_mean(word, rule_words(), "See 'maclint rules' for the list."));
}

/// Options of `check` as they were typed.
struct CheckWords {
    std::vector<std::string> paths, outputs, select, ignore, severity;
    std::string format, dialect = "auto", control, config, stdin_name, jobs, fail_on = "warning",
                        max_findings, path = "short", colour = "auto";
    bool isolated = false, show_config = false, quiet = false, no_timestamps = false, timing = false;
};

/// An empty name comes from a variable that nobody has set.
auto not_empty(std::string_view option) {
    return [option](const std::string& word) {
        if (word.empty())
            refuse(std::string(option) + " wants the name of a file. Write one, or leave it out.");
    };
}

void declare_check(CLI::App& check, CheckWords& words) {
    const auto repeatable = [](CLI::Option* option) { return option->allow_extra_args(false); };
    check.add_option("PATH", words.paths, "Files and folders; '-' reads standard input (default: .)")
        ->type_name("");
    check.add_option("--format", words.format, "What goes to standard output: text, concise, json or sarif")
        ->type_name("FORMAT");
    repeatable(check.add_option("--output", words.outputs, "Also write a report to a file; may be repeated"))
        ->type_name("FORMAT:FILE");
    check
        .add_option("--dialect", words.dialect, "Language of all files: auto, " + enumerate(dialect_names()))
        ->type_name("NAME");
    check.add_option("--control", words.control, "Control that all files are for")->type_name("NAME");
    repeatable(check.add_option("--select", words.select,
                                "Only these rules: codes, names, prefixes such as MAC3, ALL"))
        ->type_name("RULES");
    repeatable(check.add_option("--ignore", words.ignore, "Not these rules"))->type_name("RULES");
    repeatable(check.add_option("--severity", words.severity, "Change a severity to error, warning or note"))
        ->type_name("RULE=LEVEL");
    check
        .add_option("--config", words.config,
                    "This configuration instead of the nearest " + std::string(configuration_name))
        ->type_name("FILE")
        ->each(not_empty("--config"));
    check.add_flag("--isolated", words.isolated, "No configuration at all");
    check.add_flag("--show-config", words.show_config, "Print what holds for each file, and why");
    check.add_option("--stdin-filename", words.stdin_name, "Name under which standard input is linted")
        ->type_name("FILE")
        ->each(not_empty("--stdin-filename"));
    check.add_option("--jobs", words.jobs, "Threads (default: one a core)")->type_name("N");
    check
        .add_option(
            "--fail-on", words.fail_on,
            "Least severity that makes the exit status 1: error, warning, note or never (default: warning)")
        ->type_name("LEVEL");
    check
        .add_option("--max-findings", words.max_findings,
                    "Report no more than N findings, errors first, or all (default: all, on a terminal 100)")
        ->type_name("N");
    check.add_option("--path", words.path, "Steps to a finding in a text report: full, short or none")
        ->type_name("DETAIL");
    check.add_option("--color", words.colour, "auto, always or never; NO_COLOR is respected")
        ->type_name("WHEN");
    check.add_flag("--quiet", words.quiet, "No summary, notes or progress");
    check.add_flag("--no-timestamps", words.no_timestamps,
                   "No times in reports, so that equal runs give equal files");
    check.add_flag("--timing", words.timing, "Say on standard error where the time of the run went");
}

Sink sink_of(const std::string& output) {
    const auto colon = output.find(':');
    if (colon == std::string::npos || colon + 1 == output.size())
        refuse("--output does not take '" + output +
               "'. Write FORMAT:FILE, for instance sarif:maclint.sarif.");
    const std::string path = output.substr(colon + 1);
    const bool printed = path == "/dev/stdout" || path == "/dev/fd/1" || path == "/proc/self/fd/1";
    return {choose("--output", output.substr(0, colon), formats), printed ? "-" : path};
}

std::vector<Sink> sinks_of(const CheckWords& words) {
    std::vector<Sink> sinks;
    for (const std::string& output : words.outputs) {
        Sink sink = sink_of(output);
        if (std::ranges::find(sinks, sink.path, &Sink::path) != sinks.end())
            refuse("--output names '" + shown(sink.path) +
                   "' twice. Name another file for one of the reports.");
        sinks.push_back(std::move(sink));
    }
    const bool printed = std::ranges::any_of(sinks, [](const Sink& sink) { return sink.path == "-"; });
    if (!words.format.empty() && printed)
        refuse("--format and --output FORMAT:- both write to standard output. Leave one out.");
    if (!printed)
        sinks.push_back(
            {words.format.empty() ? Format::text : choose("--format", words.format, formats), "-"});
    return sinks;
}

std::pair<std::string, Severity> severity_of(const std::string& setting) {
    const auto equals = setting.find('=');
    if (equals == std::string::npos)
        refuse("--severity does not take '" + setting + "'. Write RULE=LEVEL, for instance MAC501=error.");
    const std::string rules = setting.substr(0, equals);
    const std::string level = setting.substr(equals + 1);
    require_rules("--severity", {rules});
    const auto severity = severity_named(level);
    if (!severity) refuse_word("--severity", level, {"error", "warning", "note"});
    return {rules, *severity};
}

Overrides overrides_of(const CheckWords& words) {
    Overrides overrides;
    overrides.dialect = find_dialect(words.dialect);
    if (overrides.dialect == nullptr && words.dialect != "auto") {
        auto known = dialect_names();
        known.insert(known.begin(), "auto");
        refuse_word("--dialect", words.dialect, known);
    }
    overrides.control = words.control;
    overrides.select = split_at_commas(words.select);
    overrides.ignore = split_at_commas(words.ignore);
    require_rules("--select", overrides.select);
    require_rules("--ignore", overrides.ignore);
    for (const std::string& setting : split_at_commas(words.severity))
        overrides.severity.push_back(severity_of(setting));
    if (words.isolated && !words.config.empty())
        refuse("--isolated and --config exclude each other. Leave one out.");
    overrides.config_path = words.config;
    overrides.isolated = words.isolated;
    return overrides;
}

/// A control may be one of the configuration's own: those are known only later, unless there is no
/// configuration.
void require_control(const Overrides& overrides) {
    if (overrides.control.empty() || find_control(overrides.control) != nullptr || !overrides.isolated)
        return;
    refuse_word("--control", overrides.control, control_names());
}

CheckRequest check_request(const CheckWords& words) {
    CheckRequest request;
    request.paths = words.paths.empty() ? std::vector<std::string>{"."} : words.paths;
    if (!platform::shell_expands_wildcards()) request.paths = with_wildcards_expanded(request.paths);
    request.sinks = sinks_of(words);
    request.overrides = overrides_of(words);
    require_control(request.overrides);
    request.show_config = words.show_config ? ShowConfig::yes : ShowConfig::no;
    request.stdin_name = words.stdin_name.empty() ? std::string(default_stdin_name) : words.stdin_name;
    request.jobs = words.jobs.empty() ? std::max(1U, std::thread::hardware_concurrency())
                                      : number("--jobs", words.jobs, 1U, most_jobs);
    if (words.fail_on != "never") {
        request.fail_on = severity_named(words.fail_on);
        if (!request.fail_on) refuse_word("--fail-on", words.fail_on, {"error", "warning", "note", "never"});
    }
    if (words.max_findings == "all")
        request.max_findings = std::numeric_limits<std::size_t>::max();
    else if (!words.max_findings.empty())
        request.max_findings = number<std::size_t>("--max-findings", words.max_findings, 0, 1'000'000'000);
    request.path = choose("--path", words.path, path_details);
    request.colour = choose("--color", words.colour, colours);
    request.quiet = words.quiet;
    request.timestamps = !words.no_timestamps;
    request.timing = words.timing;
    return request;
}

/// What CLI11 took for more than it knows.
void refuse_unknown(const CLI::App& app) {
    for (const std::string& word : app.remaining()) {
        std::vector<std::string> known;
        for (const CLI::Option* option : app.get_options())
            if (!option->get_lnames().empty()) known.push_back("--" + option->get_lnames().front());
        const std::string name = word.substr(0, word.find('='));
        if (word.starts_with('-') && word != "-")
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
        throw Refused{{""}};
    } catch (const CLI::ParseError& error) {
        refuse(std::string(error.what()) + ". See 'maclint " + app.get_name() + " --help'.");
    }
    refuse_unknown(app);
}

std::string help_of(const CLI::App& app) { return app.help("maclint"); }

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
           "  maclint --version           the version\n\n" +
           check.help("maclint") +
           "\nExit status: 0 nothing at or above --fail-on, 1 findings, 2 wrong usage, configuration or "
           "input.\n";
}

Request read_check(std::vector<std::string> arguments, bool with_overview) {
    CLI::App app("", "check");
    CheckWords words;
    app.set_help_flag("--help,-h", "This text");
    declare_check(app, words);
    if (with_overview) return PrintRequest{overview(app)};
    try {
        parse(app, std::move(arguments));
    } catch (const Refused& refused) {
        if (refused.error.message.empty()) return PrintRequest{overview(app)};
        throw;
    }
    suggest_command(words.paths);
    return check_request(words);
}

Request read_rules(std::vector<std::string> arguments) {
    CLI::App app("The list of rules.", "rules");
    std::string format = "text";
    RulesRequest request;
    app.set_help_flag("--help,-h", "This text");
    app.add_option("--format", format, "text, json or markdown")->type_name("FORMAT");
    app.add_option("--write-docs", request.docs_folder, "Write one page a rule and an index into this folder")
        ->type_name("DIR");
    try {
        parse(app, std::move(arguments));
    } catch (const Refused& refused) {
        if (refused.error.message.empty()) return PrintRequest{help_of(app)};
        throw;
    }
    request.format = choose("--format", format, list_formats);
    return request;
}

Request read_explain(std::vector<std::string> arguments) {
    CLI::App app("A rule's page.", "explain");
    ExplainRequest request;
    app.set_help_flag("--help,-h", "This text");
    std::string colour = "auto";
    app.add_option("RULE", request.rule, "Code or name, in any case, or a part of it")->type_name("");
    app.add_option("--color", colour, "auto, always or never; NO_COLOR is respected")->type_name("WHEN");
    try {
        parse(app, std::move(arguments));
    } catch (const Refused& refused) {
        if (refused.error.message.empty()) return PrintRequest{help_of(app)};
        throw;
    }
    request.colour = choose("--color", colour, colours);
    if (request.rule.empty())
        refuse("explain needs a rule. Write 'maclint explain MAC303', or see 'maclint rules'.");
    return request;
}

} // namespace

Request read_command_line(std::vector<std::string> arguments) {
    const std::string first = arguments.empty() ? "" : arguments.front();
    if (first == "--version") return PrintRequest{"maclint " MACLINT_VERSION "\n"};
    const bool is_command = std::ranges::find(commands, first) != commands.end();
    if (is_command) arguments.erase(arguments.begin());
    try {
        if (first == "rules") return read_rules(std::move(arguments));
        if (first == "explain") return read_explain(std::move(arguments));
        return read_check(std::move(arguments), first == "--help" || first == "-h");
    } catch (const Refused& refused) {
        return refused.error;
    }
}

} // namespace maclint::cli
