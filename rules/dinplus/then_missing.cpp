//! DIN402: an IF that no THEN follows.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule then_missing{
    .code = "DIN402",
    .name = "then-missing",
    .aliases = "",
    .summary = "IF that no THEN follows",
    .why = "Without THEN the control does not know where the branch begins.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .on_by_default = true,
    .off_reason = "",
    .data_flow = false,
    .messages = {{"plain", "No THEN follows '{0}'. Add THEN in a block of its own."}},
    .bad = {{"dinplus", "MACHINING\n"
                        "N10 INPUT(\"Diameter\",#l1)\n"
                        "N11 IF #l1>60\n"
                        "N12 G0 X100 Z2\n"
                        "N13 ENDIF\n"
                        "N14 M30\n"
                        "END\n"}},
    .good = {{"dinplus", "MACHINING\n"
                         "N10 INPUT(\"Diameter\",#l1)\n"
                         "N11 IF #l1>60\n"
                         "N12 THEN\n"
                         "N13 G0 X100 Z2\n"
                         "N14 ENDIF\n"
                         "N15 M30\n"
                         "END\n"}},
    .alarms = {},
    .sources = {"SEED-003:19643-19645"},
    .check = SyntaxErrorKind::then_missing,
};

} // namespace maclint::rules
