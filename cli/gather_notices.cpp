//! Counted first, then the first of each kind speaks for all.
#include "cli/gather_notices.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace maclint::cli {
namespace {

constexpr std::size_t most_named_alone = 3;

struct Group {
    std::size_t files = 0;
    std::string folder = {}; ///< that holds all of them; empty: the current one
};

std::string folder_of(std::string_view path) {
    const std::size_t slash = path.rfind('/');
    return std::string(path.substr(0, slash == std::string_view::npos ? 0 : slash));
}

bool lies_in(std::string_view path, std::string_view folder) {
    return folder.empty() || path == folder || (path.starts_with(folder) && path[folder.size()] == '/');
}

/// Kinds of files that were named are others than those of files that were found.
std::pair<std::string, bool> key_of(const Notice& notice) { return {notice.what, notice.named}; }

} // namespace

std::vector<Notice> gather_by_kind(std::vector<Notice> notices) {
    std::map<std::pair<std::string, bool>, Group> groups;
    for (const Notice& notice : notices) {
        if (notice.what.empty()) continue;
        Group& group = groups[key_of(notice)];
        if (group.files++ == 0) group.folder = folder_of(notice.path);
        while (!lies_in(notice.path, group.folder)) group.folder = folder_of(group.folder);
    }
    std::vector<Notice> gathered;
    for (Notice& notice : notices) {
        const auto found = groups.find(key_of(notice));
        if (found == groups.end() ||
            (found->second.files != 0 && found->second.files <= (notice.named ? most_named_alone : 1))) {
            gathered.push_back(std::move(notice));
            continue;
        }
        if (found->second.files == 0) continue; // told already
        const Group group = std::exchange(found->second, {});
        const std::string here = notice.path.starts_with('/') ? "/" : ".";
        const std::string folder = group.folder.empty() ? here : group.folder;
        gathered.push_back({notice.kind, folder,
                            std::to_string(group.files) + " files are not linted: " + notice.what + " (" +
                                notice.path + " and others). Say --show-files to see which."});
    }
    return gathered;
}

} // namespace maclint::cli
