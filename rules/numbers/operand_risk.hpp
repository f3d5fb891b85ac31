//! What rules say of an operation that has no value for what a program may be given.
#pragma once

#include "analyzer/queries/operand_risks.hpp"
#include "rules/reporter.hpp"

namespace maclint::rules {

/// Reports where the operation may have no value, once for each variable that decides it, and not where its
/// operand is one number: with the message of the evidence, "passed", "left-out", "lets-zero-pass",
/// "asked-vacancy", "others-checked" or "unchecked". {0} is the operation, {1} the operand, {2} the variable;
/// {3} the other variable, the check or the line of the call, {4} the calling program. A call that shows it
/// makes it a warning, as does a program that checks its other arguments; else it is a note.
void report_risks(const ProgramAnalysis& analysis, Operation operation, Reporter& reporter);

} // namespace maclint::rules
