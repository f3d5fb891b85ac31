//! Findings for what is wrong with a text before any flow is looked at.
#pragma once

#include "rules/rule.hpp"

#include <string>

namespace maclint {

/// One finding for every syntax error of the kind: the message "cure" where a cure is known and the rule has
/// it, otherwise "plain"; their arguments are the offending text and the cure. Errors with the same reason in
/// one program have one cause.
void report_syntax_error(const ProgramFile& file, SyntaxErrorKind kind, Reporter& reporter);

/// For Finding::same_cause.
[[nodiscard]] std::string same_cause(const ProgramFile& file, const SyntaxError& error);

} // namespace maclint
