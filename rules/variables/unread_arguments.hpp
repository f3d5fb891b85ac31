//! What MAC211 says.
#pragma once

#include "analyzer/queries/calls/unread_arguments.hpp"
#include "rules/reporter.hpp"

#include <vector>

namespace maclint::rules {

/// Of one call: the arguments that nothing names, or one that is overwritten.
void report_unread(const ProgramAnalysis& analysis, const std::vector<queries::UnreadArgument>& unread,
                   Reporter& reporter);

/// Of the defaults that replace what was passed to the program.
void report_defaults(const ProgramAnalysis& analysis, Reporter& reporter);

} // namespace maclint::rules
