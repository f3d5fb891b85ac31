//! Options are declared to CLI11 as texts; what they may say is checked here, so that the answer can be a
//! good one.
#include "cli/options/check_options.hpp"

#include "analyzer/dialect/dialect.hpp"
#include "analyzer/source/platform/console.hpp"
#include "analyzer/source/platform/output.hpp"
#include "cli/fix/add_suppressions.hpp"
#include "cli/input/wildcards.hpp"
#include "cli/options/choices.hpp"
#include "cli/text/guess.hpp"
#include "cli/text/shown.hpp"
#include "rules/listed.hpp"

#include <algorithm>
#include <limits>
#include <thread>
#include <utility>

#include <CLI/CLI.hpp>

namespace maclint::cli {
namespace {

constexpr std::string_view default_stdin_name = "stdin.nc";

void add_file(CLI::App& app, const std::string& option, std::string& word, const std::string& text) {
    app.add_option(option, word, text)->type_name("FILE");
}

/// Which findings count, of those that there are.
void declare_gate(CLI::App& check, CheckWords& words) {
    add_file(check, "--baseline", words.baseline, "Findings that this file knows do not count");
    check.add_flag("--no-baseline", words.no_baseline, "All findings count, whatever the configuration says");
    add_file(check, "--write-baseline", words.write_baseline,
             "Write this file: what is found now is known from then on");
    check.add_flag("--prune-baseline", words.prune_baseline, "Take what is gone out of the baseline");
    check.add_flag("--fail-on-gone", words.fail_on_gone,
                   "Exit status 1 where the baseline knows findings that are gone, too");
    check
        .add_option("--since", words.since,
                    "Only findings that show a line changed since this git revision, such as HEAD")
        ->type_name("REV")
        ->each([](const std::string& word) {
            if (word.starts_with('-'))
                refuse("--since wants a git revision. Write a commit, a branch or a tag, for instance HEAD.");
        });
}

void declare_fixes(CLI::App& check, CheckWords& words) {
    check.add_flag("--fix", words.fix,
                   "Correct programs where a fix is safe: no block does anything else than it can only mean");
    check.add_flag("--unsafe-fixes", words.unsafe_fixes,
                   "Beside --fix or --diff, fixes that somebody who knows the program should look at, too");
    check.add_flag("--diff", words.diff,
                   "Print what --fix or --add-suppressions would change, and change nothing");
    check.add_flag("--add-suppressions", words.add_suppressions,
                   "Write a comment that allows it for each finding from --fail-on on");
    check.add_option("--reason", words.reason, "Why they are allowed, for --add-suppressions")
        ->type_name("TEXT");
}

void declare_discovery(CLI::App& check, CheckWords& words) {
    check.add_flag("--force-exclude", words.force_exclude,
                   "What is excluded or ignored by git is not checked when it is named, too");
    check.add_flag("--no-gitignore", words.no_gitignore, "Search folders for what git ignores, too");
    check.add_flag("--follow-links", words.follow_links,
                   "Follow links out of the folders that are searched, too");
    check
        .add_option("--max-file-size", words.max_file_size,
                    "Larger files are an error and are not read: 500M, 2G or bytes (default: 1G)")
        ->type_name("SIZE");
    check.add_flag("--vendor", words.vendor,
                   "Warnings and notes in programs of a maker (vendor code) count, too");
    check.add_flag("--error-on-empty", words.error_on_empty, "A run that checks no program is an error");
}

bool is_standard_output(const std::string& path) {
    return path == "-" || platform::names_standard_output(path);
}

Sink sink_of(const std::string& output) {
    const auto colon = output.find(':');
    if (colon == std::string::npos || colon + 1 == output.size())
        refuse("--output does not take '" + output +
               "'. Write FORMAT:FILE, for instance sarif:maclint.sarif.");
    const std::string path = output.substr(colon + 1);
    return {choose("--output", output.substr(0, colon), formats), is_standard_output(path) ? "-" : path};
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
    if (!severity) refuse_word("--severity", level, severity_words());
    return {rules, *severity};
}

/// The words of a list; one of commas alone is as good as empty.
std::vector<std::string> listed(std::string_view option, const std::vector<std::string>& lists) {
    std::vector<std::string> words = split_at_commas(lists);
    if (words.empty() && !lists.empty())
        refuse(std::string(option) + " has no word between its commas. Write one, or leave the option out.");
    return words;
}

/// Refuses the first word that `add` finds wrong.
template<class Add>
void take_words(std::string_view option, const std::vector<std::string>& lists, const Add& add) {
    for (const std::string& word : listed(option, lists))
        if (const auto wrong = add(word)) refuse(std::string(option) + ": " + wrong->message + ".");
}

MachineFacts machine_of(const CheckWords& words) {
    MachineFacts machine;
    take_words("--codes", words.codes, [&](std::string_view word) { return machine.add_codes(word); });
    take_words("--lacks", words.lacks, [&](std::string_view word) { return machine.add_missing(word); });
    take_words("--calls", words.calls, [&](std::string_view word) { return machine.add_assignment(word); });
    const ControlModel& all = *find_control("fanuc"); // that has options
    take_words("--options", words.options,
               [&](std::string_view word) { return machine.add_option(word, all); });
    if (!words.axes.empty())
        if (const auto wrong = machine.set_axes(words.axes)) refuse("--axes: " + wrong->message + ".");
    return machine;
}

Overrides overrides_of(const CheckWords& words) {
    Overrides overrides;
    overrides.dialect = find_dialect(words.dialect);
    if (overrides.dialect == nullptr && words.dialect != "auto")
        refuse_word("--dialect", words.dialect, dialect_words());
    overrides.control = words.control;
    overrides.machine = machine_of(words);
    overrides.select = listed("--select", words.select);
    overrides.ignore = listed("--ignore", words.ignore);
    require_rules("--select", overrides.select);
    require_rules("--ignore", overrides.ignore);
    for (const std::string& setting : listed("--severity", words.severity))
        overrides.severity.push_back(severity_of(setting));
    if (words.isolated && !words.config.empty())
        refuse("--isolated and --config exclude each other. Leave one out.");
    overrides.config_path = words.config;
    overrides.isolated = words.isolated;
    overrides.vendor = words.vendor;
    overrides.named_are_vendor = words.force_exclude; // a commit hook names what it finds
    return overrides;
}

ExemptionChoice exemptions_of(const CheckWords& words) {
    ExemptionChoice choice{.withheld = words.show_withheld ? Withheld::listed : Withheld::dropped};
    for (const std::string& word : listed("--without-exemption", words.without_exemption)) {
        const auto exemption = find_exemption(word);
        if (!exemption)
            refuse("--without-exemption does not know '" + shown(word) + "'." +
                   did_you_mean(word, exemption_words(), "'maclint explain RULE' lists those of a rule."));
        choice.without.push_back(*exemption);
    }
    return choice;
}

/// A control may be one of the configuration's own: those are known only later, unless there is no
/// configuration.
void require_control(const Overrides& overrides) {
    if (overrides.control.empty() || find_control(overrides.control) != nullptr || !overrides.isolated)
        return;
    refuse_word("--control", overrides.control, control_names());
}

void exclude(std::string_view one, std::string_view other, std::string_view why) {
    refuse(std::string(one) + " and " + std::string(other) + " exclude each other: " + std::string(why) +
           ". Leave one out.");
}

/// Comments are written as fixes are.
void read_suppressions(const CheckWords& words, CheckRequest& request) {
    if (!words.add_suppressions) {
        if (!words.reason.empty())
            refuse("--reason says why findings are allowed. Write --add-suppressions beside it.");
        return;
    }
    if (words.fix) exclude("--add-suppressions", "--fix", "fix first, allow what is left then");
    if (words.reason.empty())
        refuse(
            "--add-suppressions wants to know why the findings are allowed. Write --reason \"proven on the "
            "machine\".");
    if (const auto wrong = wrong_reason(words.reason)) refuse(*wrong);
    request.allowing_reason = words.reason;
}

/// Reads the request's paths and sinks, too.
void read_fixes(const CheckWords& words, CheckRequest& request) {
    read_suppressions(words, request);
    if (!words.fix && !words.diff && !words.add_suppressions) {
        if (words.unsafe_fixes)
            refuse("--unsafe-fixes says which fixes are taken. Write --fix or --diff beside it.");
        return;
    }
    const std::string_view option = words.fix                ? "--fix"
                                    : words.add_suppressions ? "--add-suppressions"
                                                             : "--diff";
    if (words.fix && words.diff) exclude("--diff", "--fix", "one of them changes nothing");
    if (words.show_config) exclude(option, "--show-config", "that checks nothing");
    if (words.show_files) exclude(option, "--show-files", "that checks nothing");
    if (!words.write_baseline.empty()) exclude(option, "--write-baseline", "what is fixed is not known");
    if (words.prune_baseline) exclude(option, "--prune-baseline", "fix first, prune then");
    if (words.diff && (!words.format.empty() || !words.outputs.empty()))
        refuse("--diff prints a difference and no report. Leave --format and --output out.");
    if (words.add_suppressions && words.unsafe_fixes)
        exclude("--add-suppressions", "--unsafe-fixes", "it fixes nothing");
    if (words.diff && words.statistics) exclude("--diff", "--statistics", "it prints no report");
    if (words.diff && words.show_withheld) exclude("--diff", "--show-withheld", "it prints no report");
    if (std::ranges::find(request.paths, "-") != request.paths.end())
        refuse(std::string(option) + " does not take standard input. Name the file.");
    request.fix_use = words.diff ? FixUse::shown : FixUse::written;
    request.fixes_wanted = words.unsafe_fixes ? FixesWanted::all : FixesWanted::safe;
}

/// A baseline is read or written: what is known already is to be found when it is written.
void read_gate(const CheckWords& words, CheckRequest& request) {
    if (!words.write_baseline.empty()) {
        constexpr std::string_view write = "--write-baseline";
        if (!words.baseline.empty()) exclude("--baseline", write, "what is written is all that is found");
        if (words.prune_baseline) exclude("--prune-baseline", write, "what is written is never gone");
        if (words.fail_on_gone) exclude("--fail-on-gone", write, "what is written is never gone");
        if (!words.since.empty()) exclude("--since", write, "what is written is all that is found");
        if (is_standard_output(words.write_baseline))
            refuse("--write-baseline wants the name of a file. Standard output has the report.");
    }
    if (words.no_baseline && !words.baseline.empty())
        exclude("--baseline", "--no-baseline", "one of them names what the other leaves out");
    if (words.no_baseline && words.prune_baseline)
        exclude("--prune-baseline", "--no-baseline", "nothing is left to prune");
    if (words.fail_on_gone && words.no_baseline)
        exclude("--fail-on-gone", "--no-baseline", "nothing is known that could be gone");
    if (words.fail_on_gone && words.prune_baseline)
        exclude("--fail-on-gone", "--prune-baseline", "what is gone is taken out");
    request.overrides.baseline = words.baseline;
    request.overrides.no_baseline = words.no_baseline || !words.write_baseline.empty();
    request.write_baseline = words.write_baseline;
    request.prune_baseline = words.prune_baseline;
    request.fail_on_gone = words.fail_on_gone;
    request.since = words.since;
}

} // namespace

namespace {

CLI::Option* repeatable(CLI::Option* option) { return option->allow_extra_args(false); }

void begin_group(CLI::App& check, const std::string& name) { check.option_defaults()->group(name); }

void declare_machine(CLI::App& check, CheckWords& words) {
    check
        .add_option("--dialect", words.dialect,
                    "Language of all files: auto, " + rules::listed(dialect_names(), " and "))
        ->type_name("NAME");
    check.add_option("--control", words.control, "Control that all files are for")->type_name("NAME");
    repeatable(check.add_option("--codes", words.codes,
                                "The machine's own codes, such as G310 or M50-M59: all of their letter"))
        ->type_name("CODES");
    repeatable(
        check.add_option("--lacks", words.lacks, "Codes whose option the machine has not, such as G51"))
        ->type_name("CODES");
    repeatable(
        check.add_option("--calls", words.calls,
                         "Codes that call programs, such as G81=O9010, or by their parameter, 6050=81"))
        ->type_name("CODE=PROGRAM");
    repeatable(
        check.add_option("--options", words.options,
                         "All options of a FANUC that the machine has, as 'maclint controls' lists them"))
        ->type_name("OPTIONS");
    check.add_option("--axes", words.axes, "Letters of all axes of the machine, such as XYZA")
        ->type_name("LETTERS");
}

void declare_selection(CLI::App& check, CheckWords& words) {
    repeatable(check.add_option(
                   "--select", words.select,
                   "Only these rules: codes, names, rows such as MAC523/G83.Q, prefixes such as MAC3, ALL"))
        ->type_name("RULES");
    repeatable(check.add_option("--ignore", words.ignore, "Not these rules"))->type_name("RULES");
    repeatable(check.add_option("--severity", words.severity, "Change a severity to error, warning or note"))
        ->type_name("RULE=LEVEL");
    repeatable(check.add_option("--without-exemption", words.without_exemption,
                                "Guesses that are not made, such as MAC319/waits-for-others; "
                                "'maclint explain RULE' lists a rule's"))
        ->type_name("EXEMPTIONS");
    check.add_flag("--show-withheld", words.show_withheld,
                   "Report what a rule's exemptions hold back, too, and which; it does not count");
}

void declare_configuration(CLI::App& check, CheckWords& words) {
    add_file(check, "--config", words.config,
             "This configuration instead of the nearest " + std::string(configuration_name));
    check.add_flag("--isolated", words.isolated, "No configuration at all");
    check.add_flag("--show-config", words.show_config, "Print what holds for each file, and why");
}

void declare_reports(CLI::App& check, CheckWords& words) {
    check
        .add_option("--format", words.format,
                    "What goes to standard output: " + rules::listed(words_of(formats), " and "))
        ->type_name("FORMAT");
    repeatable(check.add_option("--output", words.outputs, "Also write a report to a file; may be repeated"))
        ->type_name("FORMAT:FILE");
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
    check.add_flag("--quiet,-q", words.quiet, "No summary, notes or progress");
    check.add_flag("--no-timestamps", words.no_timestamps,
                   "No times in reports, so that equal runs give equal files");
    check.add_flag("--statistics", words.statistics, "Count the findings by rule and by file, too");
    check.add_flag("--timing", words.timing, "Say on standard error where the time of the run went");
}

} // namespace

void declare_check(CLI::App& check, CheckWords& words) {
    check.add_option("PATH", words.paths, "Files and folders; '-' reads standard input (default: .)")
        ->type_name("");
    begin_group(check, "What the programs are for");
    declare_machine(check, words);
    begin_group(check, "Which rules");
    declare_selection(check, words);
    begin_group(check, "Configuration");
    declare_configuration(check, words);
    begin_group(check, "Reports");
    declare_reports(check, words);
    begin_group(check, "Known findings and changes");
    declare_gate(check, words);
    begin_group(check, "Correcting programs");
    declare_fixes(check, words);
    begin_group(check, "Which files");
    declare_discovery(check, words);
    check.add_flag("--show-files", words.show_files,
                   "List what is read, what is passed over, and why; check nothing");
    add_file(check, "--stdin-filename", words.stdin_name, "Name under which standard input is linted");
    begin_group(check, "Threads");
    check.add_option("--jobs", words.jobs, "Threads (default: one a core)")->type_name("N");
}

namespace {

/// What --show-config prints is no report.
void read_show_config(const CheckWords& words, CheckRequest& request) {
    if (!words.show_config) return;
    if (words.show_files) refuse("--show-config and --show-files exclude each other. Leave one out.");
    if (!words.outputs.empty()) exclude("--output", "--show-config", "it writes no report");
    request.show_config = ShowConfig::yes;
    if (!words.format.empty())
        request.config_format = choose("--show-config --format", words.format, plain_list_formats);
}

} // namespace

unsigned jobs_in(const std::string& word) {
    constexpr unsigned most = 1024;
    if (word.empty()) return std::max(1U, std::thread::hardware_concurrency());
    return number("--jobs", word, 1U, most);
}

CheckRequest check_request(const CheckWords& words) {
    CheckRequest request;
    request.paths = words.paths.empty() ? std::vector<std::string>{"."} : words.paths;
    if (!platform::shell_expands_wildcards()) request.paths = with_wildcards_expanded(request.paths);
    request.sinks = sinks_of(words);
    request.overrides = overrides_of(words);
    require_control(request.overrides);
    read_show_config(words, request);
    request.show_files = words.show_files ? ShowFiles::yes : ShowFiles::no;
    request.stdin_name = words.stdin_name.empty() ? std::string(default_stdin_name) : words.stdin_name;
    request.jobs = jobs_in(words.jobs);
    if (words.fail_on != "never") {
        request.fail_on = severity_named(words.fail_on);
        if (!request.fail_on) refuse_word("--fail-on", words.fail_on, fail_on_words());
    }
    if (words.max_findings == "all")
        request.max_findings = std::numeric_limits<std::size_t>::max();
    else if (!words.max_findings.empty())
        request.max_findings = number<std::size_t>("--max-findings", words.max_findings, 0, 1'000'000'000);
    if (!words.max_file_size.empty())
        request.overrides.max_file_size = size_in_bytes("--max-file-size", words.max_file_size);
    request.path = choose("--path", words.path, path_details);
    request.colour = choose("--color", words.colour, colours);
    request.quiet = words.quiet;
    request.timestamps = !words.no_timestamps;
    request.timing = words.timing;
    request.statistics = words.statistics;
    read_gate(words, request);
    read_fixes(words, request);
    request.discovery = {.gitignore = !words.no_gitignore,
                         .follow_links = words.follow_links,
                         .force_exclude = words.force_exclude,
                         .list_passed_over = words.show_files};
    request.error_on_empty = words.error_on_empty;
    request.exemptions = exemptions_of(words);
    return request;
}

} // namespace maclint::cli
