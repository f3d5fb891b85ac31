//! Reads of values that the control owns.
#pragma once

#include "analyzer/program/model.hpp"

#include <string_view>

namespace maclint::queries {

/// Whether an expression behind the place, or a program that the rest calls, may read the value, "#i99" as it
/// is written, in any letters.
[[nodiscard]] bool may_be_read_behind(const Program& program, std::string_view value, Offset place);

} // namespace maclint::queries
