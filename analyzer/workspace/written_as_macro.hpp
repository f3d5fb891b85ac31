//! Programs that end as a main program does, and are macros all the same.
#pragma once

#include "analyzer/program/model.hpp"

#include <optional>

namespace maclint {

/// The first argument that a program reads as only a macro does: no block above sets what a letter of a call
/// reaches, and it asks whether that was passed, or bears a number of macros and reads it. Nothing for a
/// program that does not; whether it returns to a caller is not looked at.
[[nodiscard]] std::optional<ExpressionId> find_macro_argument(const Program& program);

} // namespace maclint
