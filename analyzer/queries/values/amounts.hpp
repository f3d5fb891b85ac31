//! Which expressions are used as amounts.
#pragma once

#include "analyzer/program/model.hpp"

#include <optional>
#include <vector>

namespace maclint::queries {

/// For every expression of the program, by its id, the one that calculates with it as an amount: multiplies
/// or divides it, gives it to a function. Nothing for the others, and for what is only added up: `#4014-53`
/// is the number of the work offset.
[[nodiscard]] std::vector<std::optional<ExpressionId>> calculations_with_amounts(const Program& program);

} // namespace maclint::queries
