//! MAC326: more than one statement after THEN.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule then_multiple_statements{
    .code = "MAC326",
    .name = "then-multiple-statements",
    .summary = "More than one statement follows THEN",
    .why = "THEN takes one statement. The control stops at the second, which the author counts on in"
           " the same case.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .yields_to = "MAC122",
    .messages = {{"plain", "More than one statement after THEN: the control stops at '{0}'.",
                  "Repeat the IF for it, or let a GOTO jump over several blocks."}},
    .bad = {{"fanuc", R"nc(
O9326(CLAMP)
IF[#100GT5.]THEN#100=5. #101=1
G0 X#100 Y#101
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9326(CLAMP)
IF[#100LE5.]GOTO1
#100=5.
#101=1
N1 G0 X#100 Y#101
M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "125", "FORMAT ERROR IN MACRO"},
               {"FANUC 16i/18i/21i", "127", "NC, MACRO STATEMENT IN SAME BLOCK"}},
    .sources = {"SEED-001:381"},
    .check = SyntaxErrorKind::more_after_then,
};

} // namespace maclint::rules
