//! MAC327: words after THEN.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule then_nc_statement{
    .code = "MAC327",
    .name = "then-nc-statement",
    .summary = "Words follow THEN, which takes a macro statement",
    .why = "THEN takes an assignment or another macro statement. Older series stop at a word there."
           " Some makers take words, and no manual at hand says it of the newer series.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .yields_to = "MAC122",
    .messages = {{"plain", "Words after THEN: the control takes a macro statement there, and stops at '{0}'.",
                  "Let IF and GOTO jump over a block with the words."},
                 {"unknown",
                  "Words after THEN: older series stop at '{0}', and no manual says what this control"
                  " does.",
                  "Let IF and GOTO jump over a block with the words, or name the control (--control)."}},
    .bad = {{"fanuc", R"nc(
O9327(LIFT)
IF[#100EQ2]THEN G0 Z50.
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9327(LIFT)
IF[#100NE2]GOTO5
G0 Z50.
N5 M30
)nc"}},
    .sources = {"T: alarm 127 of older series"},
    .check = SyntaxErrorKind::words_after_then,
};

} // namespace maclint::rules
