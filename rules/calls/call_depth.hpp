//! Calls that go beyond a limit of the control, and the chains that lead to them.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"
#include "rules/finding.hpp"

#include <string>
#include <vector>

namespace maclint::rules {

/// The calls of the program that reach the first level beyond the limit. Deeper ones have the same cause.
[[nodiscard]] std::vector<CallSite> calls_beyond(const ProgramAnalysis& analysis, Counted counted, int limit);

/// "O1 > O9001 > O9002", from the outermost program over the analysed one to the callee.
[[nodiscard]] std::string chain_words(const ProgramAnalysis& analysis, const ProgramAnalysis& callee,
                                      Counted counted);

/// The calls that lead to the program, outermost first, as steps of the finding's path.
void add_chain(Finding& finding, const ProgramAnalysis& analysis, Counted counted);

} // namespace maclint::rules
