//! MAC307: text after a GOTO.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule goto_extra_words{
    .code = "MAC307",
    .name = "goto-extra-words",
    .summary = "Something stands after a GOTO in its block",
    .why = "A jump and anything else do not share a block: the control stops. Where it did not,"
           " nothing after the GOTO would run.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .yields_to = "MAC122",
    .messages = {{"plain", "Text after a GOTO: the control stops at '{0}'.",
                  "Give it a block of its own, before the GOTO if it is to run."}},
    .bad = {{"fanuc", R"nc(
O9307(COOLANT)
G0 X10.
IF[#100EQ2]GOTO5 M8
M9
N5 M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9307(COOLANT)
G0 X10.
M8
IF[#100EQ2]GOTO5
M9
N5 M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "127", "NC, MACRO STATEMENT IN SAME BLOCK"},
               {"FANUC 30i/0i-D", "127", "DUPLICATE NC,MACRO STATEMENT"}},
    .sources = {"GH-ALM", "T: the number of the alarm"},
    .check = SyntaxErrorKind::words_after_jump,
};

} // namespace maclint::rules
