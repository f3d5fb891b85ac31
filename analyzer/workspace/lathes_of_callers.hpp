//! For which lathes programs are written that do not show it themselves.
#pragma once

#include "analyzer/workspace/outline.hpp"

#include <span>
#include <vector>

namespace maclint {

/// By file, in the order of `files`: the G code system of the lathes from which alone its programs are
/// called, over others that do not show their machine either; 0 where the file shows its machine, nobody
/// calls it, some callers are for mills or for lathes of another system, or its codes are not those of the
/// system.
[[nodiscard]] std::vector<char> lathes_of_callers(std::span<const FileOutline> files);

} // namespace maclint
