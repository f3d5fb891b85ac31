//! SIN302: a jump whose label stands before it and behind it.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule ambiguous_label{
    .code = "SIN302",
    .name = "ambiguous-label",
    .summary = "GOTO names a label that stands before it and behind it",
    .why = "GOTO looks forward first, so it never goes to the label before it, which may be the one "
           "that was meant.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"cure",
                  "Two labels for one jump: '{0}' goes to that of line {1}, and one stands before it, too.",
                  "Write GOTOB or GOTOF, or rename one of the labels."}},
    .bad = {{"sinumerik", R"nc(
CUT_OFF: G1 X10
R2=R2+1
IF R2<3 GOTO CUT_OFF
CUT_OFF: G1 X20
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
CUT_OFF: G1 X10
R2=R2+1
IF R2<3 GOTOB CUT_OFF
CUT_OFF: G1 X20
M30
)nc"}},
    .sources = {"NCI"},
    .check = SyntaxErrorKind::ambiguous_jump,
};

} // namespace maclint::rules
