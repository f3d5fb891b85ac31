//! SIN104: control words of other languages.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule foreign_control_word{
    .code = "SIN104",
    .name = "control-word-of-another-control",
    .summary = "THEN, ELSEIF, DO1, END1: words that other controls have",
    .why = "The control cannot read the block, and stops with an alarm when it comes to it.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .needs = {Capability::paired_words},
    .messages = {{"cure", "Control word of another control: the control stops at '{0}', and wants {1}.", ""}},
    .bad = {{"sinumerik", R"nc(
IF R1>2 THEN
G0 X10
ENDIF
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
IF R1>2
G0 X10
ELSE
IF R1==1
G0 X5
ENDIF
ENDIF
M30
)nc"}},
    .alarms = {{"SINUMERIK", "12080", "syntax error at the text shown", false}},
    .sources = {"JP11 p.107", "HLS"},
    .check = SyntaxErrorKind::foreign_keyword,
};

} // namespace maclint::rules
