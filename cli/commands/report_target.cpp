//! A program is known by having been named as one to check, by its name, or by its text.
#include "cli/commands/report_target.hpp"

#include "analyzer/dialect/dialect.hpp"
#include "analyzer/source/content.hpp"
#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/output.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "cli/suggest.hpp"

#include <algorithm>
#include <array>

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

/// Extensions that texts of all kinds bear say nothing.
bool is_named_like_program(const std::string& path) {
    return has_nc_extension(path) && is_worth_a_note(path);
}

/// What text and concise reports write beside places in programs, which alone look like blocks.
bool may_be_report(std::string_view text) {
    constexpr std::array<std::string_view, 4> words = {" checked", "error[", "warning[", "note["};
    return std::ranges::any_of(
        words, [&](std::string_view word) { return text.find(word) != std::string_view::npos; });
}

/// What text and concise reports begin with, whatever the programs say that they quote: a finding, or the
/// summary.
bool begins_like_report(std::string_view text) {
    const std::string_view line = text.substr(0, text.find('\n'));
    if (line.ends_with(" checked)") || line.find(" checked, ") != std::string_view::npos) return true;
    constexpr std::array<std::string_view, 3> severities = {"error[", "warning[", "note["};
    return std::ranges::any_of(severities, [&](std::string_view severity) {
        const std::size_t at = line.find(severity);
        return at == 0 || (at != std::string_view::npos && line.substr(0, at).ends_with(": "));
    });
}

bool holds_program(const std::string& path) {
    if (platform::kind_of(platform::path_of(path)) != platform::FileKind::regular) return false;
    const auto result = Source::read_file(path);
    const auto* source = std::get_if<Source>(&result);
    if (source == nullptr || classify(source->bytes()) != Content::text) return false;
    if (begins_like_report(source->bytes())) return false;
    const Detection detection = detect_dialect(*source);
    return !detection.not_nc_text && (detection.certain || !may_be_report(source->bytes()));
}

Notice refusal(const std::string& path, std::string_view what) {
    return {NoticeKind::configuration, "",
            "--output would write a report over '" + shown(path) + "', which " + std::string(what) +
                ". Name another file for the report."};
}

} // namespace

std::optional<Notice> refuse_targets(const std::vector<Sink>& sinks, const std::vector<InputFile>& files,
                                     const Settings& settings) {
    for (const auto& [format, path] : sinks) {
        if (path == "-") continue;
        if (platform::is_standard_output(path))
            return Notice{NoticeKind::configuration, "",
                          "--output would write '" + shown(path) +
                              "', where standard output goes, too. Name another file for one of them."};
        for (const Sink& other : sinks)
            if (&other.path != &path && other.path != "-" && will_be_same_file(other.path, path))
                return Notice{NoticeKind::configuration, "",
                              "--output names one file twice, as '" + shown(path) + "' and as '" +
                                  shown(other.path) + "'. Name another file for one of the reports."};
        if (was_named(files, path)) return refusal(path, "is one of the files to check");
        if (is_configuration(settings, path)) return refusal(path, "is a configuration");
        if (holds_program(path)) return refusal(path, "holds an NC program");
        if (is_named_like_program(path))
            return Notice{NoticeKind::configuration, "",
                          "--output would write a report to '" + shown(path) +
                              "', which is named like an NC program. Name another file for the report."};
    }
    return std::nullopt;
}

} // namespace maclint::cli
