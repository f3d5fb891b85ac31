//! What a folder is is told by the names of its files.
#include "cli/engine/same_numbers.hpp"

#include "analyzer/dialect/number_limits.hpp"
#include "analyzer/program/model.hpp"
#include "rules/reporter.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

namespace maclint::cli {
namespace {

constexpr std::string_view duplicate_number = "MAC453";

std::string_view folder_of(std::string_view path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string_view::npos ? std::string_view() : path.substr(0, slash);
}

std::string_view name_of(std::string_view path) { return path.substr(path.rfind('/') + 1); }

std::string_view stem_of(std::string_view path) {
    const std::string_view name = name_of(path);
    return name.substr(0, name.find('.'));
}

/// `O1001.nc`, `1001`
bool is_named_after(std::string_view path, std::int64_t number) {
    std::string_view digits = stem_of(path);
    if (!digits.empty() && (digits.front() == 'O' || digits.front() == 'o')) digits.remove_prefix(1);
    digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
    return digits == std::to_string(number);
}

/// `O1001_OLD.nc`, `O1001.bak`, `COPY OF O1001.nc` beside O1001.nc.
bool is_version(std::string_view path, std::int64_t number) {
    return stem_of(path).find(std::to_string(number)) != std::string_view::npos;
}

struct Holder {
    std::size_t place;
    bool alone; ///< the only program of its file: others may be copies of a whole memory
};

using Holders = std::vector<Holder>;

/// A folder of the control, or of files, and what stands in it.
struct Folder {
    bool complete = false;
    std::size_t files = 0;
    std::map<std::int64_t, Holders> holders;
};

/// The programs of the folder may be those of several machines, or several versions.
bool is_collection(const Folder& folder) {
    const auto twice = static_cast<std::size_t>(
        std::ranges::count_if(folder.holders, [](const auto& row) { return row.second.size() > 1; }));
    constexpr std::size_t files_a_slip = 20;
    return twice > 1 + folder.files / files_a_slip;
}

} // namespace

SameNumbers::SameNumbers(const Snapshot& snapshot, std::span<const FileOutline> outlines) {
    using Key = std::pair<std::string_view, std::string>; // language, folder on the disk and on the control
    std::map<Key, Folder> folders;
    for (std::size_t i = 0; i < outlines.size(); ++i) {
        const SnapshotFile& file = snapshot.files[i];
        if (file.input.standard_input) continue; // what an editor or a pipe holds is a copy
        const std::string_view path = file.input.path;
        std::map<std::int64_t, bool> seen; // a number twice in one file is told by the rule itself
        for (const ProgramOutline& program : outlines[i].programs) {
            if (!program.number || program.local || seen.contains(*program.number)) continue;
            seen[*program.number] = true;
            const bool complete = file.settings.complete && file.settings.configuration != nullptr;
            const std::string on_disk =
                complete ? file.settings.configuration->folder : std::string(folder_of(path));
            Folder& folder = folders[{program.language, on_disk + '\n' + program.folder}];
            folder.complete = complete;
            if (seen.size() == 1) ++folder.files;
            folder.holders[*program.number].push_back({i, outlines[i].programs.size() == 1});
        }
    }
    const auto path_of = [&](const Holder& holder) -> std::string_view {
        return snapshot.files[holder.place].input.path;
    };
    for (const auto& [key, folder] : folders) {
        if (!folder.complete && is_collection(folder)) continue;
        for (const auto& [number, holders] : folder.holders) {
            if (holders.size() < 2) continue;
            const auto bears_it = std::ranges::find_if(
                holders, [&](const Holder& holder) { return is_named_after(path_of(holder), number); });
            const Holder& owner = bears_it == holders.end() ? holders.front() : *bears_it;
            const bool certain = folder.complete || (bears_it != holders.end() && holders.size() == 2 &&
                                                     std::ranges::all_of(holders, &Holder::alone));
            if (!certain) continue;
            for (const Holder& other : holders) {
                if (&other == &owner || (!folder.complete && is_version(path_of(other), number))) continue;
                taken_[other.place].push_back({number, std::string(name_of(path_of(owner)))});
            }
        }
    }
}

std::vector<Finding> SameNumbers::findings_in(std::size_t place, const ProgramFile& file) const {
    const auto taken = taken_.find(place);
    if (taken == taken_.end() || number_limits(*file.control) == nullptr) return {};
    Reporter reporter(*find_rule(duplicate_number));
    for (const Taken& number : taken->second) {
        const auto program = std::ranges::find(file.programs, number.number, &Program::number);
        if (program == file.programs.end() || program->name_span.empty()) continue;
        Finding& finding = reporter.report({file, program->name_span}, program->name_span, "other-file",
                                           {std::string(program->slice(program->name_span)), number.by});
        if (!file.control->assumed) continue;
        finding.severity = Severity::warning;
        finding.alarm = {};
    }
    return reporter.take();
}

} // namespace maclint::cli
