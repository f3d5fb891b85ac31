//! SIN204: system variables that there are not.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule unknown_system_variable{
    .code = "SIN204",
    .name = "unknown-system-variable",
    .summary = "A system variable that the control does not have",
    .why = "The control does not find the name, and stops with an alarm.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"plain", "Unknown system variable: there is no '{0}'.", "Correct the name."}},
    .bad = {{"sinumerik", R"nc(
R20=$AA_MWP[Z]
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
R20=$AA_MW[Z]
R21=$MC_CHAN_NAME[0]
M30
)nc"}},
    .alarms = {{"SINUMERIK", "12550", "name not defined, or option or function not available", false}},
    .sources = {"SV"},
    .check = SyntaxErrorKind::unknown_system_variable,
};

} // namespace maclint::rules
