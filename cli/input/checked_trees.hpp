//! What came with the folders that are checked must not steer where maclint writes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace maclint::cli {

/// The folders that a run was asked to check, each with the repository around it.
class CheckedTrees {
  public:
    /// `paths`: files and folders, as they were named.
    explicit CheckedTrees(const std::vector<std::string>& paths);

    /// Why a file must not be written: "through 'out', a link that …", or nothing. Links outside of the trees
    /// are the user's own.
    [[nodiscard]] std::optional<std::string> objection_to_writing(const std::string& path) const;

  private:
    [[nodiscard]] bool hold(const std::filesystem::path& path) const;

    std::vector<std::filesystem::path> roots_; ///< after all links
};

} // namespace maclint::cli
