//! What comes of a row that is not kept, where no line says it.
#pragma once

#include "rules/check.hpp"
#include "rules/words/table_text.hpp"

namespace maclint {

/// What comes of a value that a list of the manual does not hold.
inline constexpr TableText no_other_value = "the manual knows no other";

/// A clause, as WordRow::effect.
[[nodiscard]] TableText usual_effect(RowStatement says);

} // namespace maclint
