//! DIN905: a slide that the program head does not name.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule slide_not_in_head{
    .code = "DIN905",
    .name = "slide-not-in-head",
    .summary = "A block is for a slide that the program head does not name",
    .why = "The control runs the program on the slides of its head: the block runs on none, or another "
           "slide was meant.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"cure", "Slide without a place in the head: '{0}', where #SLIDE names {1}.",
                  "Add it to the head, or correct the block."}},
    .bad = {{"dinplus", R"nc(
PROGRAM HEAD
#SLIDE $1$2
MACHINING
$3 N10 G0 X60 Z2
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
PROGRAM HEAD
#SLIDE $1$2
MACHINING
$2 N10 G0 X60 Z2
N99 M30
END
)nc"}},
    .sources = {"SEED-003:10148", "SEED-003:2999-3015"},
    .check = SyntaxErrorKind::slide_not_in_head,
};

} // namespace maclint::rules
