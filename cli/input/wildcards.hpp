//! `*.nc` to the names of files, where the shell leaves that to the program.
#pragma once

#include <string>
#include <vector>

namespace maclint::cli {

/// Puts in the place of each path with '*' or '?' what bears such a name, in the order of the names and in
/// any case, as the shell of Windows would have it: '*.*' is everything. A path that nothing fits stays.
[[nodiscard]] std::vector<std::string> with_wildcards_expanded(const std::vector<std::string>& paths);

} // namespace maclint::cli
