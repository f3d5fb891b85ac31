//! DIN514: descriptions of transfer values.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule param_description_limits{
    .code = "DIN514",
    .name = "param-description-limits",
    .summary = "The description of a transfer value has an unknown letter or unit, is too long, or there "
               "are too many",
    .why = "The dialog of the call is made from the descriptions: what it cannot read it leaves out, and "
           "the operator does not see what to enter.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"cure", "Description of a transfer value: '{0}', but {1}.", "Correct it."}},
    .bad = {{"dinplus", R"nc(
%DWELL.ncs
[//]
[la=9; s=Seconds]
[//]
MACHINING
N1 G4 F#__la
RETURN
)nc"},
            {"dinplus", R"nc(
%DWELL.ncs
[//]
[la=0; s=Seconds for which the spindle turns]
[//]
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
    .sources = {"SEED-003:19954-19971"},
    .check = SyntaxErrorKind::wrong_description,
};

} // namespace maclint::rules
