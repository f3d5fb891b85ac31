//! Goes from name to name, with the names that are still ahead.
#include "cli/input/links.hpp"

#include "analyzer/source/platform/files.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace maclint::cli {
namespace {

namespace fs = std::filesystem;

void put_before(std::vector<fs::path>& ahead, const fs::path& relative) {
    const std::vector<fs::path> names(relative.begin(), relative.end());
    ahead.insert(ahead.end(), names.rbegin(), names.rend());
}

} // namespace

std::optional<fs::path> follow_links(const fs::path& path, const MayFollow& may_follow) {
    constexpr int most_links = 40; // as systems have it
    fs::path at = path.root_path();
    std::vector<fs::path> ahead; // the next name last
    put_before(ahead, path.relative_path());
    for (int links = 0; !ahead.empty();) {
        const fs::path name = std::move(ahead.back());
        ahead.pop_back();
        if (name.empty() || name == ".") continue;
        if (name == "..") {
            at = at.parent_path();
            continue;
        }
        at /= name;
        const auto target = platform::link_target(at);
        if (!target) continue;
        if (++links > most_links || !may_follow(*target)) return std::nullopt;
        at = target->is_absolute()          ? target->root_path()
             : target->has_root_directory() ? at.root_path()
                                            : at.parent_path();
        put_before(ahead, target->relative_path());
    }
    return at;
}

LinkEnd end_of(const fs::path& path, std::span<const fs::path> folders) {
    const auto is_on_drive = [&](const fs::path& target) {
        return std::ranges::any_of(folders, [&](const fs::path& folder) {
            return platform::lies_in(target.root_name(), folder.root_name());
        });
    };
    bool leaves = false;
    const auto end = follow_links(path, [&](const fs::path& target) {
        leaves = target.has_root_name() && (!target.has_root_directory() || !is_on_drive(target));
        return !leaves;
    });
    if (!end) return leaves ? LinkEnd::outside : LinkEnd::nowhere;
    const bool inside =
        std::ranges::any_of(folders, [&](const fs::path& folder) { return platform::lies_in(*end, folder); });
    return inside ? LinkEnd::inside : LinkEnd::outside;
}

bool leaves_drive(const fs::path& path, const fs::path& folder) {
    const fs::path whole = folder / path;
    if (!whole.has_root_name() && !folder.has_root_name()) return false;
    const std::vector<fs::path> drive = {folder.root_path()};
    if (!platform::lies_in(whole.root_name(), folder.root_name())) return true;
    return end_of(whole, drive) == LinkEnd::outside;
}

} // namespace maclint::cli
