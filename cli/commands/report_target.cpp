//! A program is known by having been named as one to check, by its name, or by its text.
#include "cli/commands/report_target.hpp"

#include "analyzer/dialect/dialect.hpp"
#include "analyzer/source/content.hpp"
#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/output.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "analyzer/source/read.hpp"
#include "cli/gate/baseline_file.hpp"
#include "cli/input/checked_trees.hpp"
#include "cli/input/own_report.hpp"
#include "cli/input/program_name.hpp"
#include "cli/input/size_limits.hpp"
#include "cli/text/letters.hpp"
#include "cli/text/shown.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string>
#include <string_view>

namespace maclint::cli {
namespace {

bool are_same_file(const std::string& one, const std::string& other) {
    return platform::are_same_file(platform::path_of(one), platform::path_of(other));
}

/// The same, of files that need not be there yet.
bool will_be_same_file(const std::string& one, const std::string& other) {
    return are_same_file(one, other) || platform::written_path(one) == platform::written_path(other);
}

bool was_named(const std::vector<InputFile>& files, const std::string& path) {
    return std::ranges::any_of(files, [&](const InputFile& file) {
        return file.named && !file.standard_input && are_same_file(file.path, path);
    });
}

bool is_configuration(const Settings& settings, const std::string& path) {
    return std::ranges::any_of(settings.configurations(), [&](const auto& configuration) {
        return std::ranges::any_of(configuration->sources,
                                   [&](const Source& source) { return are_same_file(source.path(), path); });
    });
}

/// The beginning tells it: what is in the way may be as large as it likes.
bool holds_program(const std::string& path) {
    if (platform::kind_of(platform::path_of(path)) != platform::FileKind::regular) return false;
    std::string bytes = beginning_of_file(path, mebibyte);
    if (bytes.size() == mebibyte) bytes.resize(bytes.rfind('\n') + 1); // whole lines; no line end: nothing
    const Source beginning = Source::from_bytes(path, std::move(bytes));
    if (classify(beginning.bytes()) != Content::text || is_own_report(beginning.bytes())) return false;
    return !detect_dialect(beginning).not_nc_text;
}

/// Whether the next run would take the file for one, all links followed; on some systems in any case.
bool is_named_like_configuration(const std::string& path) {
    const auto is_named_so = [](const std::filesystem::path& file) {
        return in_lower_case(platform::text_of(file.filename())) == configuration_name;
    };
    const auto file = platform::path_of(path);
    return is_named_so(file) || is_named_so(platform::place_of(file));
}

enum class Written : std::uint8_t { report, baseline };

/// A file that is to be written.
struct Target {
    std::string_view option; ///< that names it
    Written what;
    std::string path;
};

std::string_view word_for(Written what) { return what == Written::report ? "report" : "baseline"; }

std::vector<Target> targets_of(const CheckRequest& request) {
    std::vector<Target> targets;
    for (const Sink& sink : request.sinks)
        if (sink.path != "-") targets.push_back({"--output", Written::report, sink.path});
    if (!request.write_baseline.empty())
        targets.push_back({"--write-baseline", Written::baseline, request.write_baseline});
    return targets;
}

/// The baselines that may get pruned.
std::vector<Target> pruned_by(const CheckRequest& request, const Settings& settings) {
    constexpr std::string_view prune = "--prune-baseline";
    if (!request.prune_baseline) return {};
    if (!request.overrides.baseline.empty()) return {{prune, Written::baseline, request.overrides.baseline}};
    std::vector<Target> targets;
    for (const auto& configuration : settings.configurations())
        if (!configuration->baseline.empty())
            targets.push_back({prune, Written::baseline, configuration->baseline});
    return targets;
}

Notice refusal(const Target& target, const std::string& where) {
    const std::string what(word_for(target.what));
    return {NoticeKind::configuration, "",
            std::string(target.option) + " would write a " + what + " " + where +
                ". Name another file for the " + what + "."};
}

Notice refuse_over(const Target& target, std::string_view what) {
    return refusal(target, "over '" + shown(target.path) + "', which " + std::string(what));
}

Notice refuse_twice(const Target& one, const Target& other) {
    const std::string names =
        std::string("'").append(shown(one.path)).append("' and as '").append(shown(other.path)).append("'");
    if (one.option == other.option)
        return {NoticeKind::configuration, "",
                std::string(one.option) + " names one file twice, as " + names +
                    ". Name another file for one of the reports."};
    return {NoticeKind::configuration, "",
            std::string(one.option) + " and " + std::string(other.option) + " name one file, as " + names +
                ". Name another file for one of them."};
}

/// Whether what came with the checked folders would lead a report or a baseline elsewhere.
std::optional<Notice> refuse_ways(const CheckRequest& request, const Settings& settings,
                                  std::vector<Target> targets) {
    std::ranges::move(pruned_by(request, settings), std::back_inserter(targets));
    if (targets.empty()) return std::nullopt;
    std::vector<std::string> paths = request.paths;
    std::ranges::replace(paths, "-", request.stdin_name);
    const CheckedTrees trees(paths);
    for (const Target& target : targets)
        if (const auto objection = trees.objection_to_writing(target.path))
            return refusal(target, *objection);
    return std::nullopt;
}

} // namespace

std::optional<Notice> refuse_targets(const CheckRequest& request, const std::vector<InputFile>& files,
                                     const Settings& settings) {
    const std::vector<Target> targets = targets_of(request);
    if (auto refused = refuse_ways(request, settings, targets)) return refused; // first: no link is followed
    for (const Target& target : targets) {
        const std::string& path = target.path;
        if (platform::is_standard_output(path))
            return Notice{NoticeKind::configuration, "",
                          std::string(target.option) + " would write '" + shown(path) +
                              "', where standard output goes, too. Name another file for one of them."};
        for (const Target& other : targets)
            if (&other != &target && will_be_same_file(other.path, path)) return refuse_twice(target, other);
        if (was_named(files, path)) return refuse_over(target, "is one of the files to check");
        if (is_configuration(settings, path)) return refuse_over(target, "is a configuration");
        if (target.what == Written::report && holds_baseline(path))
            return refuse_over(target, "is a baseline");
        if (holds_program(path)) return refuse_over(target, "holds an NC program");
        if (is_named_like_configuration(path))
            return refusal(target, "to '" + shown(path) + "', which is named like a configuration");
        if (is_named_like_program(path))
            return refusal(target, "to '" + shown(path) + "', which is named like an NC program");
    }
    return std::nullopt;
}

} // namespace maclint::cli
