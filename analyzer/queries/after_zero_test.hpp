//! What a program does with a vacant variable that a test for 0 has let pass.
#pragma once

#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>

namespace maclint::queries {

/// The text that uses the variable on the side of the test that the program takes when it is vacant, with
/// nothing set in between and no test for vacancy. Arithmetic takes vacant for 0, which is what the test was
/// to prevent; a word counts only where the other side of the test ends in an alarm, for otherwise leaving
/// the word out may be meant. A block that cannot be read uses all that it names but the first, unless it is
/// a test. Nothing: the vacancy does no harm. `test` compares the variable with 0 by EQ or NE.
[[nodiscard]] std::optional<Span> use_after_zero_test(const ProgramAnalysis& analysis,
                                                      const dataflow::Comparison& test,
                                                      const dataflow::Value& tested, Variable variable);

} // namespace maclint::queries
