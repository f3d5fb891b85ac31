//! Findings for what is wrong with a text before any flow is looked at.
#pragma once

#include "rules/rule.hpp"

namespace maclint {

/// One finding for every syntax error of the kind: the message "cure" where a cure is known and the rule has
/// it, otherwise "plain"; their arguments are the offending text and the cure.
void report_syntax_error(const ProgramFile& file, SyntaxErrorKind kind, Reporter& reporter);

} // namespace maclint
