//! Takes fixes as long as they leave each other alone.
#include "cli/fix/choose.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace maclint::cli {
namespace {

/// Two that only meet would come out in the order of whoever applies them.
bool touch(const Edit& one, const Edit& other) {
    return one.span.begin <= other.span.end && other.span.begin <= one.span.end;
}

/// The changes of one round, by the file's path.
class Round {
  public:
    [[nodiscard]] bool has_room_for(const Fix& fix) const {
        return std::ranges::none_of(fix.edits, [&](const Edit& edit) {
            const auto file = files_.find(edit.source->path());
            return file != files_.end() && std::ranges::any_of(file->second.edits, [&](const Edit& other) {
                       return touch(edit, other);
                   });
        });
    }

    void take(const Fix& fix, const Source& of_finding) {
        for (const Edit& edit : fix.edits) {
            FileChange& file = files_.try_emplace(edit.source->path()).first->second;
            file.source = edit.source;
            file.edits.push_back(edit);
        }
        if (const auto file = files_.find(of_finding.path()); file != files_.end()) ++file->second.findings;
    }

    [[nodiscard]] std::vector<FileChange> take_files() {
        std::vector<FileChange> files;
        for (auto& [path, file] : files_) {
            std::ranges::sort(file.edits, {}, [](const Edit& edit) { return edit.span.begin; });
            files.push_back(std::move(file));
        }
        return files;
    }

  private:
    std::map<std::string_view, FileChange> files_;
};

} // namespace

const Fix* wanted_fix(const Finding& finding, FixesWanted wanted) {
    const auto found = std::ranges::find_if(finding.fixes, [&](const Fix& fix) {
        return wanted == FixesWanted::all || fix.applicability == Applicability::safe;
    });
    return found == finding.fixes.end() ? nullptr : &*found;
}

std::vector<FileChange> choose_fixes(std::span<const FilteredFinding> findings, FixesWanted wanted,
                                     const std::function<bool(std::string_view path)>& may_change) {
    Round round;
    for (const FilteredFinding& filtered : findings) {
        const Fix* fix = filtered.suppressed ? nullptr : wanted_fix(filtered.finding, wanted);
        if (fix == nullptr || !round.has_room_for(*fix)) continue;
        const bool may_all = std::ranges::all_of(
            fix->edits, [&](const Edit& edit) { return may_change(edit.source->path()); });
        if (may_all) round.take(*fix, *filtered.finding.source);
    }
    return round.take_files();
}

} // namespace maclint::cli
