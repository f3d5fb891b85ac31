//! `maclint check`: find files, read, lint, report.
#include "cli/commands/commands.hpp"
#include "cli/commands/report_target.hpp"
#include "cli/commands/show_config.hpp"
#include "cli/commands/show_files.hpp"
#include "cli/config/idle_globs.hpp"
#include "cli/engine/engine.hpp"
#include "cli/fix/add_suppressions.hpp"
#include "cli/fix/fix_programs.hpp"
#include "cli/fix/unified_difference.hpp"
#include "cli/fix/write_fixed.hpp"
#include "cli/gate/gate.hpp"
#include "cli/gather_notices.hpp"
#include "cli/report/limit.hpp"
#include "cli/report/report.hpp"
#include "cli/report/statistics.hpp"
#include "cli/report/timing.hpp"
#include "cli/terminal.hpp"
#include "cli/text/guess.hpp"
#include "cli/text/shown.hpp"
#include "rules/listed.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <iterator>
#include <utility>

namespace maclint::cli {
namespace {

std::string utc_now() {
    namespace chrono = std::chrono;
    const auto now = chrono::floor<chrono::seconds>(chrono::system_clock::now());
    const auto day = chrono::floor<chrono::days>(now);
    const chrono::year_month_day date(day);
    const chrono::hh_mm_ss time(now - day);
    std::array<char, 64> text{};
    const int length =
        std::snprintf(text.data(), text.size(), "%04d-%02u-%02uT%02ld:%02ld:%02ldZ",
                      static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                      static_cast<unsigned>(date.day()), static_cast<long>(time.hours().count()),
                      static_cast<long>(time.minutes().count()), static_cast<long>(time.seconds().count()));
    return {text.data(), static_cast<std::size_t>(length)};
}

/// A --config that is wrong, a --control that neither maclint nor the configuration knows, or one that does
/// not go with --dialect ends the run.
std::optional<Notice> refuse_settings(const Overrides& overrides, Settings& settings) {
    const auto here = settings.for_folder(".");
    if (!overrides.config_path.empty() && !here) return settings.take_notices().front();
    if (overrides.control.empty()) return std::nullopt;
    const Configuration* configuration = here ? here->get() : nullptr;
    const ControlModel* control = configuration != nullptr ? configuration->control(overrides.control)
                                                           : find_control(overrides.control);
    if (control != nullptr) {
        if (overrides.dialect == nullptr || is_for(*control, *overrides.dialect)) return std::nullopt;
        return Notice{NoticeKind::configuration, "",
                      "--control " + overrides.control + " does not run what --dialect " +
                          std::string(overrides.dialect->name) + " reads. Leave one of them out."};
    }
    const auto known = configuration != nullptr ? configuration->known_controls() : control_names();
    return Notice{
        NoticeKind::configuration, "",
        "--control does not know '" + overrides.control + "'." +
            did_you_mean(overrides.control, known, "Known are " + rules::listed(known, " and ") + ".")};
}

/// The files that were asked for, and those around them that may call them or be called.
Discovered inputs_of(const CheckRequest& request, Settings& settings, std::vector<Notice>& notices) {
    Discovered found = discover(request.paths, request.stdin_name, settings, request.discovery);
    std::ranges::move(found.notices, std::back_inserter(notices));
    Discovered around = discover_context(found.files, request.paths, settings, request.discovery);
    std::ranges::move(around.notices, std::back_inserter(notices));
    std::ranges::move(around.files, std::back_inserter(found.files));
    std::ranges::stable_sort(found.files, {}, &InputFile::path);
    return found;
}

Notice nothing_checked() {
    return {NoticeKind::nothing_checked, "",
            "no NC program was checked. Correct the paths, or leave --error-on-empty out."};
}

bool fails(const Report& report, std::optional<Severity> fail_on) {
    return fail_on && std::ranges::any_of(report.findings, [&](const FilteredFinding& filtered) {
               return !filtered.suppressed && filtered.finding.severity >= *fail_on;
           });
}

int exit_status_of(const std::vector<Notice>& notices) {
    return std::ranges::any_of(notices, &Notice::is_error) ? exit_error : exit_clean;
}

int exit_of(const std::vector<Notice>& notices) {
    for (const Notice& notice : notices)
        if (notice.is_error()) print_notice(notice);
    return exit_status_of(notices);
}

bool is_for_people(Format format) { return format == Format::text || format == Format::concise; }
/// The others have no place for numbers by rule and by file.
bool holds_statistics(Format format) { return is_for_people(format) || format == Format::json; }

Report report_of(const CheckRequest& request, Result result, std::vector<Notice> notices) {
    Report report;
    report.findings = std::move(result.findings);
    report.notices = std::move(notices);
    for (std::size_t i = 0; i < result.sources.size(); ++i)
        report.read_as.emplace(result.sources[i].get(), std::move(result.read_as[i]));
    report.files = std::move(result.sources);
    report.fail_on = request.fail_on;
    report.statistics = request.statistics;
    report.withheld = request.exemptions.withheld;
    if (fails(report, request.fail_on)) report.exit_status = exit_findings;
    if (std::ranges::any_of(report.notices, &Notice::is_error)) report.exit_status = exit_error;
    if (request.max_findings) limit(report, *request.max_findings);
    return report;
}

std::string write(const Report& report, Format format, const TextStyle& style) {
    switch (format) {
    case Format::text: return write_text(report, style);
    case Format::concise: return write_concise(report, style);
    case Format::json: return write_json(report);
    case Format::sarif: return write_sarif(report);
    case Format::github: return write_github(report, style);
    case Format::gitlab: return write_gitlab(report, style);
    case Format::junit: return write_junit(report, style);
    case Format::checkstyle: return write_checkstyle(report);
    }
    return {};
}

/// Standard output comes last: a report that could not be written is an error that all others tell of.
int deliver(const CheckRequest& request, Report report) {
    const Summary summary = request.quiet ? Summary::left_out : Summary::at_the_end;
    auto sinks = request.sinks;
    std::ranges::stable_partition(sinks, [](const Sink& sink) { return sink.path != "-"; });
    for (const Sink& sink : sinks) {
        const bool printed = sink.path == "-";
        const TextStyle style{.colour = printed ? colour_for_output(request.colour) : Colour::plain,
                              .summary = summary,
                              .path = request.path,
                              .width = printed ? output_width() : usual_width};
        if (printed && output_is_terminal() && !request.max_findings && is_for_people(sink.format))
            fit_terminal(report);
        if (auto failure = write_to(sink.path, write(report, sink.format, style))) {
            print_notice(*failure);
            report.exit_status = exit_error;
            report.notices.push_back(*std::move(failure));
        }
        if (printed && report.statistics && !holds_statistics(sink.format))
            print_aside(statistics_text(report));
    }
    return report.exit_status;
}

/// What came of the programs.
struct Checked {
    Result result;
    std::vector<Notice> notices;
    std::vector<FixedFile> fixed; ///< written, or to be shown
    std::size_t allowed = 0;      ///< findings that new comments allow
};

std::string changed_words(const CheckRequest& request, const Checked& checked) {
    const bool would = request.fix_use == FixUse::shown;
    if (!request.allowing_reason.empty())
        return std::string(would ? "Would allow " : "Allowed ") + counted(checked.allowed, "finding") +
               " in " + counted(checked.fixed.size(), "file") + ".\n";
    std::size_t findings = 0;
    for (const FixedFile& file : checked.fixed) findings += file.findings;
    return std::string(would ? "Would fix " : "Fixed ") + counted(findings, "finding") + " in " +
           counted(checked.fixed.size(), "file") + ".\n";
}

/// Fixes, or comments in their place.
FixedPrograms changed_programs(const CheckRequest& request, const Snapshot& snapshot, const Analyse& analyse,
                               Checked& checked) {
    if (request.allowing_reason.empty()) return fix_programs(snapshot, request.fixes_wanted, analyse);
    const Severity least = request.fail_on.value_or(Severity::note);
    AddedSuppressions added = add_suppressions(snapshot, request.allowing_reason, least, analyse);
    checked.allowed = added.allowed;
    return std::move(added.programs);
}

Checked check_programs(const CheckRequest& request, const Snapshot& snapshot, Gate& gate,
                       Progress& progress) {
    Engine engine({.jobs = request.jobs, .exemptions = request.exemptions}, progress);
    Checked checked;
    const Analyse analyse = [&](const Snapshot& now) {
        Result result = engine.analyse(now);
        checked.notices = gate.judge(now, result);
        return result;
    };
    if (request.fix_use == FixUse::reported) {
        checked.result = analyse(snapshot);
        return checked;
    }
    FixedPrograms fixed = changed_programs(request, snapshot, analyse, checked);
    checked.result = std::move(fixed.result);
    checked.fixed = std::move(fixed.files);
    if (request.fix_use == FixUse::written)
        if (auto failures = write_fixed(checked.fixed, request.paths); !failures.empty()) {
            checked.result = analyse(snapshot); // as the files are now
            std::ranges::move(failures, std::back_inserter(checked.notices));
        }
    std::ranges::move(fixed.notices, std::back_inserter(checked.notices));
    return checked;
}

} // namespace

int run_check(const CheckRequest& request) {
    const std::string begin = utc_now();
    const auto begun = std::chrono::steady_clock::now();
    Settings settings(request.overrides, own_folders(request.paths));
    if (const auto refused = refuse_settings(request.overrides, settings)) {
        print_notice(*refused);
        return exit_error;
    }
    const bool watched = error_shows_progress() && !request.quiet;
    std::optional<Progress> progress(std::in_place,
                                     watched ? Progress::Shown::when_long : Progress::Shown::never);
    std::vector<Notice> notices;
    const Discovered inputs = inputs_of(request, settings, notices);
    const Snapshot snapshot = snapshot_of(inputs.files, settings);
    if (const auto refused = refuse_targets(request, inputs.files, settings)) {
        progress.reset();
        print_notice(*refused);
        return exit_error;
    }
    std::ranges::move(settings.take_notices(), std::back_inserter(notices));
    std::ranges::move(idle_globs(settings.configurations(), request.paths, inputs.files),
                      std::back_inserter(notices));
    RunTiming timing{.finding = std::chrono::steady_clock::now() - begun};
    ShownConfig config;
    Result result;
    Checked checked;
    bool has_baseline = false;
    bool has_stale_entries = false;
    if (request.show_config == ShowConfig::yes) {
        config = show_config(snapshot, request.config_format);
    } else if (request.show_files == ShowFiles::yes) {
        ShownFiles files = show_files(snapshot, inputs);
        std::ranges::move(files.notices, std::back_inserter(notices));
        progress.reset();
        return std::max(print_text(files.text), exit_of(notices));
    } else {
        BaselineStore baselines;
        auto opened = Gate::open(request, snapshot, baselines);
        if (const auto* refused = std::get_if<Notice>(&opened)) {
            progress.reset();
            print_notice(*refused);
            return exit_error;
        }
        auto& gate = std::get<Gate>(opened);
        checked = check_programs(request, snapshot, gate, *progress);
        result = std::move(checked.result);
        std::ranges::move(checked.notices, std::back_inserter(notices));
        has_baseline = gate.has_baseline();
        has_stale_entries = gate.has_stale_entries();
    }
    for (auto* more : {&config.notices, &result.notices})
        std::ranges::move(*more, std::back_inserter(notices));
    const bool checks = request.show_config == ShowConfig::no;
    if (request.error_on_empty && checks && result.sources.empty()) notices.push_back(nothing_checked());
    std::ranges::stable_sort(notices, {}, &Notice::path);
    notices = gather_by_kind(std::move(notices));
    progress.reset();
    for (const Notice& notice : notices)
        if (notice.is_error() || !request.quiet) print_notice(notice);
    if (request.fix_use != FixUse::reported && !request.quiet) print_aside(changed_words(request, checked));
    if (request.fix_use == FixUse::shown) {
        const int status = std::max(print_text(unified_difference(checked.fixed)), exit_status_of(notices));
        return checked.fixed.empty() ? status : std::max(status, exit_findings);
    }
    const Timing engine_timing = result.timing;
    Report report = report_of(request, std::move(result), std::move(notices));
    if (request.fail_on_gone && has_stale_entries)
        report.exit_status = std::max(report.exit_status, exit_findings);
    report.passed_over = inputs.passed_over;
    if (request.show_config == ShowConfig::yes) return std::max(print_text(config.text), report.exit_status);
    report.has_baseline = has_baseline;
    if (request.timestamps) report.times = RunTimes{begin, utc_now()};
    const auto analysed = std::chrono::steady_clock::now();
    const int status = deliver(request, std::move(report));
    const auto end = std::chrono::steady_clock::now();
    timing.reports = end - analysed;
    timing.whole = end - begun;
    if (request.timing) print_aside(write_timing(engine_timing, timing));
    return status;
}

} // namespace maclint::cli
