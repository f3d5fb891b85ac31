//! Says where the analysis has met its bounds.
#pragma once

#include "cli/notice.hpp"
#include "rules/bounds_met.hpp"

#include <mutex>
#include <optional>
#include <set>
#include <vector>

namespace maclint::cli {

/// Collects them from all groups of files; one notice tells of all bounds of a kind. May be used by several
/// threads.
class Bounds {
  public:
    void add(const std::vector<BoundMet>& met);
    /// For searches that gave up: which rules they touch, and in how many files.
    [[nodiscard]] std::optional<Notice> searches() const;
    /// For programs whose jumps are not followed one by one.
    [[nodiscard]] std::optional<Notice> jumps() const;

  private:
    mutable std::mutex mutex_;
    std::set<BoundMet> met_;
};

} // namespace maclint::cli
