//! SIN303: a FOR that counts down.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule for_never_runs{
    .code = "SIN303",
    .name = "for-never-runs",
    .summary = "A FOR begins above its end",
    .why = "FOR counts up alone: the loop is passed over.",
    .severity = Severity::warning,
    .precision = Precision::very_high,
    .needs = {Capability::paired_words},
    .messages = {{"plain", "Loop that never runs: '{0}' begins above its end, and FOR counts up.",
                  "Count down with WHILE, or turn the two around and calculate the value from the counter."}},
    .bad = {{"sinumerik", R"nc(
DEF INT ROW
FOR ROW=5 TO 1
G0 X=ROW*10
ENDFOR
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
DEF INT ROW
FOR ROW=1 TO 5
G0 X=60-ROW*10
ENDFOR
M30
)nc"}},
    .sources = {"NCI"},
    .check = SyntaxErrorKind::empty_counting,
};

} // namespace maclint::rules
