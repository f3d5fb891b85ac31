//! DIN402: an IF that no THEN follows.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule then_missing{
    .code = "DIN402",
    .name = "then-missing",
    .summary = "IF that no THEN follows",
    .why = "Without THEN the control does not know where the branch begins.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .messages = {{"plain", "Missing THEN: none follows '{0}'.", "Add THEN in a block of its own."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 INPUT("Diameter",#l1)
N11 IF #l1>60
N12 G0 X100 Z2
N13 ENDIF
N14 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 INPUT("Diameter",#l1)
N11 IF #l1>60
N12 THEN
N13 G0 X100 Z2
N14 ENDIF
N15 M30
END
)nc"}},
    .sources = {"SEED-003:19643-19645"},
    .check = SyntaxErrorKind::then_missing,
};

} // namespace maclint::rules
