//! SIN109: a jump that writes the colon of its label.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule colon_in_jump{
    .code = "SIN109",
    .name = "colon-in-jump",
    .summary = "A jump names its label with the colon",
    .why = "The colon belongs to the label, not to its name: the control cannot read the jump, and "
           "stops with an alarm.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .needs = {Capability::paired_words},
    .messages = {{"cure", "Colon in a jump: no label has the name '{0}', but '{1}'.", "Remove the colon."}},
    .bad = {{"sinumerik", R"nc(
IF R1==1 GOTOF READY:
G0 X10
READY: M30
)nc"}},
    .good = {{"sinumerik", R"nc(
IF R1==1 GOTOF READY
G0 X10
READY: M30
)nc"}},
    .alarms = {{"SINUMERIK", "12080", "syntax error at the text shown", false}},
    .sources = {"NCI"},
    .check = SyntaxErrorKind::colon_in_jump,
};

} // namespace maclint::rules
