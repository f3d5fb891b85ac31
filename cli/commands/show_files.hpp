//! `maclint check --show-files`: what is read, what is passed over, and why.
#pragma once

#include "cli/engine/snapshot.hpp"
#include "cli/input/discover.hpp"

#include <string>

namespace maclint::cli {

/// A line for each file that was asked for, and for what a search passed over, by path.
[[nodiscard]] std::string show_files(const Snapshot& snapshot, const Discovered& inputs);

} // namespace maclint::cli
