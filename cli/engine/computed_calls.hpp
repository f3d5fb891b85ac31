//! Calls whose program only the running program knows, and whom they may mean.
#pragma once

#include "analyzer/workspace/outline.hpp"
#include "cli/engine/snapshot.hpp"

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace maclint::cli {

/// Such a call may mean any program of its language on its control. The folders of configurations tell
/// controls apart; a folder in another one may be of the same control.
class ComputedCalls {
  public:
    ComputedCalls() = default;
    /// One outline a file, in the same order.
    ComputedCalls(const Snapshot& snapshot, std::span<const FileOutline> outlines);

    [[nodiscard]] bool may_mean(const SnapshotFile& file, std::string_view language) const;

  private:
    std::set<std::pair<std::string_view, std::string>> folders_; ///< languages and folders with such calls
};

} // namespace maclint::cli
