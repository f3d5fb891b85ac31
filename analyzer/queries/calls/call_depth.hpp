//! Calls that go beyond a limit of the control.
#pragma once

#include "analyzer/program/call_kinds.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <vector>

namespace maclint::queries {

/// The calls of the program that reach the first level beyond the limit, counted from the outermost program.
/// Deeper ones have the same cause and are left out.
[[nodiscard]] std::vector<CallSite> calls_beyond(const ProgramAnalysis& analysis, NestingLimit nesting,
                                                 int limit);

/// Whether what the call runs comes to a call that is beyond the level.
[[nodiscard]] bool leads_to_level(const ProgramAnalysis& analysis, const CallSite& site, NestingLimit nesting,
                                  int level);

} // namespace maclint::queries
