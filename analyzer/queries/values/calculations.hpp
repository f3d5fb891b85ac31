//! Which calculation a value is the result of.
#pragma once

#include "analyzer/dataflow/domain/value.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>

namespace maclint::queries {

/// The operation whose result the value is; nothing for a number, a variable's value at the start, a value
/// that is read from the machine or is one of several.
[[nodiscard]] std::optional<Operation> operation_of(const ProgramAnalysis& analysis,
                                                    const dataflow::Value& value);

/// Whether the value is FIX, FUP or ROUND of the other: x EQ FIX[x] asks whether x is whole.
[[nodiscard]] bool is_rounded_result(const ProgramAnalysis& analysis, const dataflow::Value& value,
                                     const dataflow::Value& of);

/// Whether the value is a quotient whose divisor may have decimals.
[[nodiscard]] bool is_quotient_of_decimals(const ProgramAnalysis& analysis, const dataflow::Value& value);

/// Whether both are whole numbers divided by the same: ROUND[#1*1000]/1000, where whole numbers that are
/// equal give equal results.
[[nodiscard]] bool are_rounded_alike(const ProgramAnalysis& analysis, const dataflow::Value& one,
                                     const dataflow::Value& other);

/// Whether rounding cannot make the value 0, nor keep it from being 0: products and quotients, roots and
/// amounts of such, sums of squares. A sine of 180 degrees is not.
[[nodiscard]] bool is_zero_as_on_paper(const ProgramAnalysis& analysis, const dataflow::Value& value);

/// Whether the value is one number, known, and the one that somebody would write for it: -0.642-2.130 is
/// -2.772, but 0.1+0.2 is not 0.3.
[[nodiscard]] bool is_as_written(const dataflow::Value& value);
[[nodiscard]] bool is_as_written(double number);

/// Whether nothing but numbers and locals of the program decides the expression: what others set, too, may
/// have changed while the program stood.
[[nodiscard]] bool is_of_own_variables(const ProgramAnalysis& analysis, ExpressionId expression);

/// Whether the value is the ABS of a difference.
[[nodiscard]] bool is_distance(const ProgramAnalysis& analysis, const dataflow::Value& value);

} // namespace maclint::queries
