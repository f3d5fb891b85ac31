//! SIN106: a remark that lacks its semicolon.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule remark_without_semicolon{
    .code = "SIN106",
    .name = "remark-without-semicolon",
    .summary = "Text that is no block: a line of dashes, or characters that code does not have",
    .why = "The control takes the text for a block, cannot read it, and stops with an alarm.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .needs = {Capability::paired_words},
    .messages = {{"plain", "Remark without its semicolon: '{0}' is no block.",
                  "Write a semicolon before it."}},
    .bad = {{"sinumerik", R"nc(
G17 G90 G54
-------- pocket --------
G0 X0 Y0
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
G17 G90 G54
;-------- pocket --------
G0 X0 Y0
M30
)nc"}},
    .alarms = {{"SINUMERIK", "12080", "syntax error at the text shown", false}},
    .sources = {"NCP19 p.52"},
    .check = SyntaxErrorKind::remark_without_sign,
};

} // namespace maclint::rules
