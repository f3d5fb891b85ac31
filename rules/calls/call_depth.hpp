//! Calls that go beyond a limit of the control, and the chains that lead to them.
#pragma once

#include "analyzer/program/call_kinds.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/rule.hpp"

#include <string>

namespace maclint::rules {

/// The program that a call runs: its name, or what the call writes for it.
[[nodiscard]] std::string name_of_callee(const ProgramAnalysis& analysis, const CallSite& site);

/// The calls of the program that reach the first level beyond the control's limit, with the call, its level,
/// the control, the limit and the chain of programs; deeper ones have the same cause. The message is "named";
/// of an assumed control "assumed", a warning, or "most" beyond what any that may be meant has.
void report_calls_beyond(const ProgramAnalysis& analysis, Reporter& reporter, NestingLimit nesting);

} // namespace maclint::rules
