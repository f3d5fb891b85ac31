//! `maclint check --show-files`: what is read, what is passed over, and why.
#pragma once

#include "cli/engine/snapshot.hpp"
#include "cli/input/discover.hpp"

#include <string>
#include <vector>

namespace maclint::cli {

struct ShownFiles {
    std::string text; ///< a line for each file that was asked for, and for what a search passed over, by path
    std::vector<Notice> notices; ///< on files that cannot be read
};

[[nodiscard]] ShownFiles show_files(const Snapshot& snapshot, const Discovered& inputs);

} // namespace maclint::cli
