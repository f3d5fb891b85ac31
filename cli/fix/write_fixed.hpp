//! Fixed programs go to the disk.
#pragma once

#include "cli/fix/fix_programs.hpp"
#include "cli/notice.hpp"

#include <string>
#include <vector>

namespace maclint::cli {

/// Writes each file whole, with the permissions that it has, and says which it could not: one that has
/// changed since it was read, that must not be written, or that a link of a checked folder (`paths`, as they
/// were named) leads out to. Those stay as they were and are taken out of `files`.
[[nodiscard]] std::vector<Notice> write_fixed(std::vector<FixedFile>& files,
                                              const std::vector<std::string>& paths);

} // namespace maclint::cli
