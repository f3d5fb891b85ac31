//! Prints the program model in one line a block, for tests and for looking at what a dialect made of a text.
#pragma once

#include "analyzer/program/model.hpp"

#include <string>

namespace maclint {

/// "add(#1, 2)", "vacant?(#3)", "modal(distance mode)".
[[nodiscard]] std::string describe(const Program& program, ExpressionId expression);
/// "#1 := 5", "if less(#1, 5) {jump 10}", "call G65 macro call 9010 A>#1=1".
[[nodiscard]] std::string describe(const Program& program, const Effect& effect);
/// A block a line: "N10 /1 effect; effect", runs as "run of 3 numbered moving, distance mode=91".
[[nodiscard]] std::string describe(const Program& program);
/// All programs, then the irregularities.
[[nodiscard]] std::string describe(const ProgramFile& file);

[[nodiscard]] std::string_view name_of(Operation operation);
[[nodiscard]] std::string_view name_of(SyntaxErrorKind syntax_error);

} // namespace maclint
