//! What comes of a row that is not kept, where no line says it.
#pragma once

#include "rules/check.hpp"

#include <string_view>

namespace maclint {

/// What comes of a value that a list of the manual does not hold.
inline constexpr std::string_view no_other_value = "the manual knows no other";

/// A clause, as WordRow::effect.
[[nodiscard]] std::string_view usual_effect(RowStatement says);

} // namespace maclint
