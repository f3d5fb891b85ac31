//! Numbers that stand in calculations and arguments where a variable of that number is meant.
#pragma once

#include "analyzer/program/model.hpp"
#include "rules/variables/bare_number_for_variable_finder.hpp"

#include <cstdint>
#include <vector>

namespace maclint::rules {

[[nodiscard]] bool is_basic_arithmetic(Operation operation);

/// Whether the expression is made of numbers alone, and calculated.
[[nodiscard]] bool is_of_numbers(const Program& program, const Apply& apply);

/// Whether the number is likely that of a variable: small ones, and round ones, are numbers.
[[nodiscard]] bool is_like_a_variable(const Program& program, std::int64_t number);

/// Adds those of calculations: in brackets of their own; where nothing reads the variable that the program
/// sets, or asks for; where a statement sets the variable to a sum of numbers. Of arguments the second.
void find_in_calculations(const Program& program, std::vector<BareNumber>& found);

} // namespace maclint::rules
