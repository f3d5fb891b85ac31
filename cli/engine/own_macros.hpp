//! Folders that hold programs which the control may run for codes of the machine's own.
#pragma once

#include "analyzer/workspace/outline.hpp"
#include "cli/engine/folders.hpp"
#include "cli/engine/snapshot.hpp"

#include <span>
#include <string_view>

namespace maclint::cli {

/// O9001 to O9029, as parameters 6050 to 6089 name them.
class OwnMacros {
  public:
    OwnMacros() = default;
    /// One outline a file, in the same order.
    OwnMacros(const Snapshot& snapshot, std::span<const FileOutline> outlines);

    /// Whether such programs lie beside the file, in a folder above it or below it.
    [[nodiscard]] bool lie_by(const SnapshotFile& file, std::string_view language) const;

  private:
    Folders folders_; ///< that hold some
};

} // namespace maclint::cli
