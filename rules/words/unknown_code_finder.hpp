//! Programs that the control may run for codes of the machine's own.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

namespace maclint::rules {

/// Whether the folder of the program holds macros that parameters make codes call, O9001 to O9029: a code
/// that no control has may mean one of them.
[[nodiscard]] bool has_macros_for_codes(const ProgramAnalysis& analysis);

} // namespace maclint::rules
