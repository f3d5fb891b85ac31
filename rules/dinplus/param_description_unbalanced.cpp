//! DIN014: a list of descriptions without its end.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule param_description_unbalanced{
    .code = "DIN014",
    .name = "param-description-unbalanced",
    .summary = "A [//] begins a list of descriptions that no other one ends",
    .why = "The dialog of the call takes all that follows for descriptions, or shows none.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"plain", "List without its end: no other [//] follows.",
                  "Write [//] behind the last description."}},
    .bad = {{"dinplus", R"nc(
%DWELL.ncs
[//]
[la=0; s=Seconds]
MACHINING
N1 G4 F#__la
RETURN
)nc"}},
    .good = {{"dinplus", R"nc(
%DWELL.ncs
[//]
[la=0; s=Seconds]
[//]
MACHINING
N1 G4 F#__la
RETURN
)nc"}},
    .sources = {"SEED-003:19960-19972"},
    .check = SyntaxErrorKind::description_unbalanced,
};

} // namespace maclint::rules
