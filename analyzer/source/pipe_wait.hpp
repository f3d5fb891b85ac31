//! Waiting for what a pipe brings, but not for ever.
#pragma once

#include <chrono>

namespace maclint {

/// How long a pipe that was named, and standard input, may stay silent: others write to the latter, and
/// people type passwords before they do.
inline constexpr std::chrono::seconds patience_with_pipes{10};
inline constexpr std::chrono::seconds patience_with_input{60};

/// Whether bytes or the end come from the open file in that time. People at a terminal may take longer.
[[nodiscard]] bool comes_in_time(int descriptor, std::chrono::milliseconds patience);

} // namespace maclint
