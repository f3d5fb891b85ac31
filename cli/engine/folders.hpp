//! Folders that hold something for the programs by them, compared as texts.
#pragma once

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace maclint::cli {

/// Of languages, and with what programs of each lie by. Languages have to outlive it.
class Folders {
  public:
    void add_that_of(const std::string& path, std::string_view language) {
        folders_.emplace(language, folder_of(path));
    }
    /// Whether one of them is the file's own, one above it or below it.
    [[nodiscard]] bool lie_by(const std::string& path, std::string_view language) const {
        const std::string own = folder_of(path);
        return std::ranges::any_of(folders_, [&](const auto& holding) {
            return holding.first == language &&
                   (own.starts_with(holding.second) || holding.second.starts_with(own));
        });
    }

  private:
    /// "shop/" of "shop/O1.nc"; "" of "O1.nc".
    static std::string folder_of(const std::string& path) { return path.substr(0, path.rfind('/') + 1); }

    std::set<std::pair<std::string_view, std::string>> folders_;
};

} // namespace maclint::cli
