//! Takes fixes as long as they leave each other alone.
#include "cli/fix/choose.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>
#include <variant>

namespace maclint::cli {
namespace {

/// The changes of one round, by the file's path.
class Round {
  public:
    /// Two edits that only meet would come out in the order of whoever applies them.
    [[nodiscard]] bool has_room_for(const Fix& fix) const {
        return std::ranges::none_of(fix.edits, [&](const Edit& edit) {
            const auto file = files_.find(edit.source->path());
            if (file == files_.end()) return false;
            const auto behind = file->second.taken.upper_bound(edit.span.end);
            return behind != file->second.taken.begin() && std::prev(behind)->second >= edit.span.begin;
        });
    }

    void take(const Fix& fix, const Source& of_finding) {
        for (const Edit& edit : fix.edits) {
            File& file = files_.try_emplace(edit.source->path()).first->second;
            file.change.source = edit.source;
            file.change.edits.push_back(edit);
            file.taken.emplace(edit.span.begin, edit.span.end);
        }
        if (const auto file = files_.find(of_finding.path()); file != files_.end())
            ++file->second.change.findings;
    }

    [[nodiscard]] bool is_empty() const { return files_.empty(); }
    [[nodiscard]] std::vector<FileChange> take_files() {
        std::vector<FileChange> files;
        for (auto& [path, file] : files_) {
            std::ranges::sort(file.change.edits, {}, [](const Edit& edit) { return edit.span.begin; });
            files.push_back(std::move(file.change));
        }
        return files;
    }

  private:
    struct File {
        FileChange change;
        std::map<Offset, Offset> taken; ///< begin and end of its edits, none of which touch
    };
    std::map<std::string_view, File> files_;
};

/// Whether the fix inserts a line that stands there already: it has been made, and did not help.
bool is_made(const Fix& fix) {
    constexpr std::string_view line_ends = "\r\n";
    return std::ranges::any_of(fix.edits, [&](const Edit& edit) {
        const std::string_view bytes = edit.source->bytes(), text = edit.text;
        const std::size_t first = text.find_first_not_of(line_ends), last = text.find_last_not_of(line_ends);
        const bool is_line = text.find('\n') != std::string_view::npos && first != std::string_view::npos;
        if (edit.span.length() > 0 || !is_line) return false;
        const std::string_view line = text.substr(first, last + 1 - first);
        const std::string_view before = bytes.substr(0, edit.span.begin);
        const std::size_t end = before.find_last_not_of(line_ends);
        return bytes.substr(edit.span.begin).starts_with(line) ||
               (end != std::string_view::npos && before.substr(0, end + 1).ends_with(line));
    });
}

/// What the command itself raises speaks of comments that may be of use when the blocks can be read.
bool waits_for_others(const Finding& finding) {
    return std::holds_alternative<RaisedByCommand>(finding.rule->check);
}

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
    for (const bool at_last : {false, true}) {
        if (!round.is_empty()) break;
        for (const FilteredFinding& filtered : findings) {
            const Fix* fix = filtered.suppressed ? nullptr : wanted_fix(filtered.finding, wanted);
            if (fix == nullptr || waits_for_others(filtered.finding) != at_last) continue;
            if (is_made(*fix) || !round.has_room_for(*fix)) continue;
            const bool may_all = std::ranges::all_of(
                fix->edits, [&](const Edit& edit) { return may_change(edit.source->path()); });
            if (may_all) round.take(*fix, *filtered.finding.source);
        }
    }
    return round.take_files();
}

} // namespace maclint::cli
