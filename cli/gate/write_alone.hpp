//! A baseline that several runs write at once loses nothing: each reads it, changes it and writes it alone.
#pragma once

#include "cli/notice.hpp"

#include <functional>
#include <string>

namespace maclint::cli {

/// Does what reads and writes the file while no other run does; says what that says, or why it cannot be
/// done.
[[nodiscard]] Notice write_alone(const std::string& path, const std::function<Notice()>& write);

} // namespace maclint::cli
