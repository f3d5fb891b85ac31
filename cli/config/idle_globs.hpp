//! Globs of a configuration that take no file: mostly mistyped, or relative to another folder than was
//! thought.
#pragma once

#include "cli/config/configuration.hpp"
#include "cli/input/discover.hpp"
#include "cli/notice.hpp"

#include <memory>
#include <string>
#include <vector>

namespace maclint::cli {

/// A note on each entry of "files", "per-file-ignores", "vendor" and "include" that takes none of the files,
/// and how to write it where that can be guessed. Only of configurations whose whole folder was asked for
/// (`paths`, as they were named): other runs see a part of the files. Entries of a configuration that another
/// one extends are for other folders, too, and are left out.
[[nodiscard]] std::vector<Notice>
idle_globs(const std::vector<std::shared_ptr<const Configuration>>& configurations,
           const std::vector<std::string>& paths, const std::vector<InputFile>& files);

} // namespace maclint::cli
