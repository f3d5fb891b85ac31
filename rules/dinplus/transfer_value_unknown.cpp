//! DIN331: #__xx of which no call can pass a value.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule transfer_value_unknown{
    .code = "DIN331",
    .name = "transfer-value-unknown",
    .summary = "No word of a call passes a value to this #__ variable",
    .why = "The variable never has a value: what is made of it is made of nothing, or of 0.",
    .severity = Severity::warning,
    .precision = Precision::very_high,
    .needs = {Capability::named_arguments},
    .messages = {{"cure", "Unknown transfer value: no word of a call sets '{0}'.", "Write '{1}'."},
                 {"plain", "Unknown transfer value: no word of a call sets '{0}'.",
                  "Use one of the transfer letters, for instance '#__lh'."}},
    .bad = {{"dinplus", R"nc(
%DWELL.ncs
MACHINING
N1 G4 F#__lg
RETURN
)nc"}},
    .good = {{"dinplus", R"nc(
%DWELL.ncs
MACHINING
N1 G4 F#__lh
RETURN
)nc"}},
    .sources = {"SEED-003:19937", "SEED-003:8527-8554"},
    .check = SyntaxErrorKind::unknown_transfer_value,
};

} // namespace maclint::rules
