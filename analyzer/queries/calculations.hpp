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

} // namespace maclint::queries
