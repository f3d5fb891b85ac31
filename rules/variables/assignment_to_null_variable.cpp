//! MAC201: #0 on the left of =.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule assignment_to_null_variable{
    .code = "MAC201",
    .name = "assignment-to-null-variable",
    .summary = "#0 is always vacant and cannot be assigned",
    .why = "The control stops with a write-protection alarm: #0 exists to be compared with and "
           "copied from.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .needs = {Capability::vacancy},
    .messages = {{"plain", "Assignment to the null variable: '{0}' is always vacant and cannot be set.",
                  "Use another variable."}},
    .bad = {{"fanuc", R"nc(
O9201(CLEAR)
#0=5
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9201(CLEAR)
#100=#0
M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "116", "WRITE PROTECTED VARIABLE"},
               {"FANUC 30i/0i-D", "116", "WRITE PROTECTED VARIABLE"}},
    .sources = {"SEED-001:160", "SEED-001:198", "GH-ALM"},
    .check = SyntaxErrorKind::assignment_to_null,
};

} // namespace maclint::rules
