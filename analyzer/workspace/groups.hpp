//! Which files have to be analysed together.
#pragma once

#include "analyzer/workspace/outline.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace maclint {

/// The files in groups that no call leaves: what is found in a program depends on the programs that call it
/// or that it may call, on theirs, and on no others. In each group, and among groups by their first file, in
/// the order of `files`; numbers are places in it.
[[nodiscard]] std::vector<std::vector<std::size_t>> groups_of(std::span<const FileOutline> files);

} // namespace maclint
