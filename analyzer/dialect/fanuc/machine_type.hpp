//! Guesses from a program's text whether it was written for a lathe.
#pragma once

#include <string_view>

namespace maclint::fanuc {

/// Only when the words leave no doubt: turning cycles, speed limits or turret positions, and nothing of a
/// mill.
[[nodiscard]] bool is_written_for_lathe(std::string_view text);

} // namespace maclint::fanuc
