//! Goes from name to name, with the names that are still ahead.
#include "cli/input/links.hpp"

#include "analyzer/source/platform/files.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace maclint::cli {
namespace {

namespace fs = std::filesystem;

class Search {
  public:
    Search(const fs::path& path, std::span<const fs::path> folders)
        : folders_(folders)
        , at_(path.root_path()) {
        go(path.relative_path());
    }

    LinkEnd run() {
        constexpr int most_links = 40; // as systems have it
        for (int links = 0; !ahead_.empty();) {
            const fs::path name = std::move(ahead_.back());
            ahead_.pop_back();
            if (name.empty() || name == ".") continue;
            if (name == "..") {
                at_ = at_.parent_path();
                continue;
            }
            at_ /= name;
            const auto target = platform::link_target(at_);
            if (!target) continue;
            if (++links > most_links) return LinkEnd::nowhere;
            if (!follow(*target)) return LinkEnd::outside;
        }
        const bool inside = std::ranges::any_of(
            folders_, [&](const fs::path& folder) { return platform::lies_in(at_, folder); });
        return inside ? LinkEnd::inside : LinkEnd::outside;
    }

  private:
    /// False where none of the folders is.
    bool follow(const fs::path& target) {
        if (target.has_root_name() && (!target.has_root_directory() || !is_on_drive(target))) return false;
        at_ = target.is_absolute()          ? target.root_path()
              : target.has_root_directory() ? at_.root_path()
                                            : at_.parent_path();
        go(target.relative_path());
        return true;
    }

    [[nodiscard]] bool is_on_drive(const fs::path& target) const {
        return std::ranges::any_of(folders_, [&](const fs::path& folder) {
            return platform::lies_in(target.root_name(), folder.root_name());
        });
    }

    void go(const fs::path& relative) {
        std::vector<fs::path> names(relative.begin(), relative.end());
        std::ranges::move(names.rbegin(), names.rend(), std::back_inserter(ahead_));
    }

    std::span<const fs::path> folders_;
    fs::path at_;                 ///< without links
    std::vector<fs::path> ahead_; ///< the next one last
};

} // namespace

LinkEnd end_of(const fs::path& path, std::span<const fs::path> folders) {
    return Search(path, folders).run();
}

bool leaves_drive(const fs::path& path, const fs::path& folder) {
    const fs::path whole = folder / path;
    if (!whole.has_root_name() && !folder.has_root_name()) return false;
    const std::vector<fs::path> drive = {folder.root_path()};
    if (!platform::lies_in(whole.root_name(), folder.root_name())) return true;
    return end_of(whole, drive) == LinkEnd::outside;
}

} // namespace maclint::cli
