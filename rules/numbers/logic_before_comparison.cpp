//! MAC728: AND and OR that bind tighter than the comparisons beside them.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule logic_before_comparison{
    .code = "MAC728",
    .name = "logic-before-comparison",
    .summary = "AND or OR joins two values where comparisons were to be joined",
    .why = "Comparisons bind looser than AND and OR: A==1 AND B<>0 compares A with 1 AND B, and the branch is"
           " taken in other cases than it seems.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"cure", "Logic before comparison: in '{0}' AND and OR join the values beside them.",
                  "Write '{1}'."},
                 {"plain", "Logic before comparison: in '{0}' AND and OR join the values beside them.",
                  "Put each comparison in brackets."}},
    .bad = {{"sinumerik", R"nc(
IF R1==1 AND R2<>0 GOTOF READY
G0 X100
READY: M30
)nc"}},
    .good = {{"sinumerik", R"nc(
IF (R1==1) AND (R2<>0) GOTOF READY
G0 X100
READY: M30
)nc"}},
    .sources = {"NCP19 p.444"},
    .check = SyntaxErrorKind::logic_outside_brackets,
};

} // namespace maclint::rules
