//! Fixed programs are shown as a difference.
#pragma once

#include "cli/fix/fix_programs.hpp"

#include <string>
#include <vector>

namespace maclint::cli {

/// As `git apply` and `patch -p1` take it, in the bytes of the files.
[[nodiscard]] std::string unified_difference(const std::vector<FixedFile>& files);

} // namespace maclint::cli
