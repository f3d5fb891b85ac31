//! What is to be analysed: files as they are at one moment.
#pragma once

#include "cli/config/settings.hpp"
#include "cli/input/discover.hpp"

#include <optional>
#include <vector>

namespace maclint::cli {

struct SnapshotFile {
    InputFile input;
    FileSettings settings;
    std::optional<Source> text = {}; ///< what an editor holds; else the file is read
};

/// Each file once; findings are wanted of those that were asked for.
struct Snapshot {
    std::vector<SnapshotFile> files;
};

/// In the order of `inputs`. Files whose configuration is wrong are left out; `settings` has the notices.
[[nodiscard]] Snapshot snapshot_of(std::vector<InputFile> inputs, Settings& settings);

} // namespace maclint::cli
