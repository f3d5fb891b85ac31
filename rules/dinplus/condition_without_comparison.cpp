//! DIN422: IF or WHILE with a value alone.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule condition_without_comparison{
    .code = "DIN422",
    .name = "condition-without-comparison",
    .summary = "IF or WHILE asks for a value, and compares it with nothing",
    .why = "A condition compares two values, or asks with DEF or BITSET: what a value alone means is not "
           "said.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"plain", "Condition without a comparison: '{0}' is compared with nothing.",
                  "Compare it, as in #l1==1."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 IF #g1
N11 THEN
N12 G4 F1
N13 ENDIF
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 IF #g1==1
N11 THEN
N12 G4 F1
N13 ENDIF
N99 M30
END
)nc"}},
    .sources = {"SEED-003:19643", "SEED-003:19774"},
    .check = SyntaxErrorKind::no_condition,
};

} // namespace maclint::rules
