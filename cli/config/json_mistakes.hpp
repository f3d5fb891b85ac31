//! What people write who do not write JSON every day.
#pragma once

#include "cli/config/json_tree.hpp"

#include <string>
#include <string_view>

namespace maclint::cli {

/// The text with a blank for each comma that only a closing bracket follows. All else stays where it is.
[[nodiscard]] std::string without_trailing_commas(std::string_view text);

/// What is wrong at a place where the parser gave up, and what to write there. `reason` is what the parser
/// says of it.
[[nodiscard]] JsonError mistake_at(std::string_view text, Offset at, std::string_view reason);

} // namespace maclint::cli
