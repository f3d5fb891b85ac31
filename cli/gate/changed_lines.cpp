//! Which repository each file belongs to; there files are compared, and lines looked up in what differs.
#include "cli/gate/changed_lines.hpp"

#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/output.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "cli/gate/compared_files.hpp"
#include "cli/input/repository.hpp"
#include "cli/text/shown.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace maclint::cli {
namespace {

using platform::path_of;
using platform::text_of;

} // namespace

std::variant<ChangedLines, Notice> ChangedLines::since(const std::string& revision,
                                                       const std::vector<InputFile>& files) {
    ChangedLines changed;
    changed.revision_ = revision;
    for (const InputFile& file : files) {
        if (!file.asked) continue;
        if (file.standard_input) changed.standard_input_.insert(file.path);
        if (file.standard_input || platform::kind_of(path_of(file.path)) == platform::FileKind::missing)
            continue;
        const auto& root = changed.root_of(platform::written_path(file.path));
        if (!root)
            return refusal_of_since("--since wants files of a git repository, and '" + shown(file.path) +
                                    "' lies in none. Leave --since out, or this file.");
        changed.histories_.try_emplace(*root);
    }
    for (auto& [root, history] : changed.histories_) {
        auto opened = RepositoryHistory::open(changed.place_of(root), revision);
        if (auto* const refused = std::get_if<HistoryRefusal>(&opened)) return std::move(refused->notice);
        history = std::get<RepositoryHistory>(std::move(opened));
    }
    return changed;
}

/// Of a file that is named after all links.
const std::optional<std::string>& ChangedLines::root_of(const std::string& path) {
    const auto folder = path_of(path).parent_path();
    const auto [entry, is_new] = roots_.try_emplace(text_of(folder));
    if (is_new)
        if (const auto root = repository_around(folder)) entry->second = text_of(*root);
    return entry->second;
}

GitPlace ChangedLines::place_of(const std::string& root) const {
    GitPlace place{.root = root};
    for (const auto& [other, history] : histories_) place.checked_roots.push_back(other);
    return place;
}

const RepositoryHistory* ChangedLines::history_of(const std::string& root, std::vector<Notice>& notices) {
    const auto [entry, is_new] = histories_.try_emplace(root);
    if (is_new) {
        auto opened = RepositoryHistory::open(place_of(root), revision_);
        if (auto* const refused = std::get_if<HistoryRefusal>(&opened)) {
            if (refused->why == HistoryRefusal::Why::unusable)
                notices.push_back(
                    {NoticeKind::left_out, "",
                     "programs in '" + shown(root) + "' count as unchanged. " + refused->notice.message});
        } else {
            entry->second = std::get<RepositoryHistory>(std::move(opened));
        }
    }
    return entry->second ? &*entry->second : nullptr;
}

std::vector<Notice> ChangedLines::compare(const std::unordered_set<const Source*>& shown,
                                          const std::vector<const Source*>& checked) {
    std::map<std::string, std::vector<FileToCompare>> by_root; // and so in the same order each time
    const auto add = [&](const Source* source, FileToCompare::Wanted wanted) {
        if (standard_input_.contains(source->path())) return;
        const std::string path = platform::written_path(source->path());
        if (const auto& root = root_of(path)) {
            by_root[*root].push_back(
                {source, text_of(path_of(path).lexically_relative(path_of(*root))), wanted});
        } else {
            keep(*source, {});
        }
    };
    for (const Source* source : shown) add(source, FileToCompare::Wanted::lines);
    for (const Source* source : checked)
        if (!shown.contains(source)) add(source, FileToCompare::Wanted::nothing);
    std::vector<Notice> notices;
    for (auto& [root, files] : by_root) {
        const RepositoryHistory* const history = history_of(root, notices);
        if (history == nullptr) {
            for (const FileToCompare& file : files) keep(*file.source, {});
            continue;
        }
        std::ranges::sort(files, {}, &FileToCompare::path);
        auto compared = compare_files(*history, revision_, files);
        for (auto& [source, ranges] : compared.ranges) keep(*source, std::move(ranges));
        std::ranges::move(compared.notices, std::back_inserter(notices));
    }
    return notices;
}

void ChangedLines::keep(const Source& source, std::vector<LineRange> ranges) {
    File file{std::move(ranges), {}};
    const std::string_view bytes = file.ranges.empty() ? std::string_view() : source.bytes();
    for (auto at = bytes.find('\n'); at != std::string_view::npos; at = bytes.find('\n', at + 1))
        file.line_feeds.push_back(static_cast<Offset>(at));
    files_[&source] = std::move(file);
}

bool ChangedLines::touch_any_line(const Source& source) const {
    const auto entry = files_.find(&source);
    return entry == files_.end() || !entry->second.ranges.empty();
}

bool ChangedLines::touch(const Source& source, Span span) const {
    const auto entry = files_.find(&source);
    if (entry == files_.end()) return true;
    const File& file = entry->second;
    const auto line_of = [&](Offset offset) {
        const auto before = std::ranges::lower_bound(file.line_feeds, offset) - file.line_feeds.begin();
        return static_cast<std::uint32_t>(before) + 1;
    };
    const std::uint32_t first = line_of(span.begin);
    const std::uint32_t last = line_of(span.empty() ? span.end : span.end - 1);
    const auto range = std::ranges::lower_bound(file.ranges, first, {}, &LineRange::last);
    return range != file.ranges.end() && range->first <= last;
}

} // namespace maclint::cli
