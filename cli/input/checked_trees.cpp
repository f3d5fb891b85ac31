//! The way to a file is gone name by name: what lies in a tree must be no link, wherever it leads.
#include "cli/input/checked_trees.hpp"

#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/output.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "cli/input/repository.hpp"
#include "cli/text/letters.hpp"
#include "cli/text/shown.hpp"

#include <algorithm>
#include <system_error>

namespace maclint::cli {
namespace {

namespace fs = std::filesystem;

/// Not made normal: the system follows "link/.." to the link's end.
fs::path as_written_from_root(const std::string& path) {
    std::error_code gone;
    return fs::absolute(platform::path_of(path), gone);
}

fs::path folder_of(const std::string& path) {
    const fs::path whole = as_written_from_root(path).lexically_normal();
    const bool is_folder = platform::kind_of(whole) == platform::FileKind::folder;
    return is_folder && whole.has_filename() ? whole : whole.parent_path();
}

std::string shown_from_here(const fs::path& path) {
    std::error_code gone;
    return shown(platform::text_of(path.lexically_normal().lexically_proximate(fs::current_path(gone))));
}

} // namespace

CheckedTrees::CheckedTrees(const std::vector<std::string>& paths) {
    for (const std::string& path : paths) {
        const fs::path named = folder_of(path);
        // A link to a part of a repository belongs to what is around the link, and around what it leads to.
        for (const fs::path& folder : {named, platform::place_of(named)}) {
            fs::path root = platform::place_of(repository_around(folder).value_or(folder));
            const bool is_new = std::ranges::find(roots_, root) == roots_.end();
            if (root.has_relative_path() && is_new) roots_.push_back(std::move(root)); // "/" is no stranger's
        }
    }
}

bool CheckedTrees::hold(const fs::path& path) const {
    return std::ranges::any_of(roots_, [&](const fs::path& root) { return platform::lies_in(path, root); });
}

std::optional<std::string> CheckedTrees::objection_to_writing(const std::string& path) const {
    const fs::path whole = as_written_from_root(path);
    fs::path at = whole.root_path();
    fs::path place = at;
    for (const fs::path& name : whole.relative_path()) {
        if (name.empty() || name == ".") continue;
        const bool inside = hold(place);
        at /= name;
        if (inside && platform::link_target(at))
            return "through '" + shown_from_here(at) + "', a link in the folder that is checked";
        place = platform::place_of(at);
        if (inside && in_lower_case(platform::text_of(place.filename())) == ".git")
            return "into '" + shown_from_here(at) + "', which is git's own";
    }
    return std::nullopt;
}

} // namespace maclint::cli
