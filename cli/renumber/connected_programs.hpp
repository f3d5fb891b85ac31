//! Programs of other files that may name blocks of a file.
#pragma once

#include "cli/engine/read.hpp"
#include "cli/engine/snapshot.hpp"

#include <memory>
#include <vector>

namespace maclint::cli {

/// The file's text, read to that extent; `notice` where it cannot be opened.
[[nodiscard]] ReadFile open_and_read(const SnapshotFile& file, Extent extent, ProgramStore& store);

/// Those among the files that the file's programs call by number, or that call them. The file itself is none.
[[nodiscard]] std::vector<std::shared_ptr<const ProgramFile>>
connected_programs(const Snapshot& around, const ProgramFile& file, ProgramStore& store);

} // namespace maclint::cli
