//! Shared variables that a program checks before it sets them.
#pragma once

#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/source/exemption.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <vector>

namespace maclint::rules {

/// By which a limit may be asked for before its value is calculated.
namespace exemptions {
inline constexpr Exemption held_against_last_value;
} // namespace exemptions

/// A test with an alarm on one side, which reads what was in the variable when the program began.
struct EarlyCheck {
    const dataflow::Read* read;
    const dataflow::Store* store; ///< that comes later
};

/// The first such read of each variable that lives as long as the control is on. Only where the program
/// stores in it once, what it calculates from its own variables and the test does not look at, and everything
/// behind the store reads that; not where a caller may have set it.
[[nodiscard]] std::vector<EarlyCheck> find_early_checks(const ProgramAnalysis& analysis);

} // namespace maclint::rules
