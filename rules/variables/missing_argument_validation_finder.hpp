//! Arguments that decide when a loop ends.
#pragma once

#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/queries/values/operand_risks.hpp"
#include "analyzer/source/exemption.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <vector>

namespace maclint::rules {

/// By which a bound may go unchecked.
namespace exemptions {
inline constexpr Exemption search_in_a_table;
} // namespace exemptions

/// A loop that goes on until its counter passes an argument. The pointers lead to facts of the program.
struct UncheckedBound {
    const dataflow::Comparison* test; ///< of the counter and the argument
    const dataflow::Read* read;       ///< of the argument, in the test
    Variable counter;
    queries::OperandRisk risk;
};

/// The loops whose bound is an argument that the program holds against nothing but their counter, one for
/// each argument, in the order of the program.
[[nodiscard]] std::vector<UncheckedBound> unchecked_bounds(const ProgramAnalysis& analysis);

} // namespace maclint::rules
