//! What rules say of a value that a program may be given, and for which it has no use.
#pragma once

#include "analyzer/queries/values/operand_risks.hpp"
#include "rules/reporter.hpp"

#include <string>
#include <vector>

namespace maclint::rules {

/// Reports the risk with the message of its evidence: "passed", "left-out", "lets-zero-pass",
/// "asked-vacancy", "others-checked" or "unchecked". After `words`, its first words, come the other variable,
/// or the check, or the line of the call and the calling program. What nothing shows is a note, the rest a
/// warning at most. The path begins with the call; its end is the rule's to add.
Finding& report_risk(const ProgramAnalysis& analysis, const queries::OperandRisk& risk, const Cause& cause,
                     Span span, std::vector<std::string> words, Reporter& reporter);

/// Reports where the operation may have no value, once for each variable that decides it, and not where its
/// operand is one number. {0} is the operation, {1} the operand, {2} the variable.
void report_risks(const ProgramAnalysis& analysis, Operation operation, Reporter& reporter);

} // namespace maclint::rules
