//! Positions that programs read by their numbers.
#pragma once

#include "analyzer/program/model.hpp"
#include "analyzer/program/tables.hpp"

namespace maclint::queries {

/// The row of the position that the expression reads: of an axis (#5041), or where a signal ended a move
/// (#5061). nullptr: it reads none.
[[nodiscard]] const VariableRange* position_read(const Program& program, ExpressionId expression);

} // namespace maclint::queries
