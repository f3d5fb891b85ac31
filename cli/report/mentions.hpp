//! Whether a text speaks of a code or a variable.
#pragma once

#include <string_view>

namespace maclint::cli {

/// "G1" in "G01 without a feed", "G30" in "G30-LEFT-ACTIVE"; not in "G1.1" or "G130". Also "#3003".
[[nodiscard]] bool mentions_code(std::string_view text, std::string_view code);

} // namespace maclint::cli
