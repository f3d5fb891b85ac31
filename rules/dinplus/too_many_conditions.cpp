//! DIN403: more than two conditions in an IF or a WHILE.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule too_many_conditions{
    .code = "DIN403",
    .name = "too-many-conditions",
    .summary = "An IF or a WHILE links more than two conditions",
    .why = "The control links at most two conditions with AND and OR.",
    .severity = Severity::error,
    .precision = Precision::high,
    .messages = {{"cure", "Too many conditions: '{0}' links {1}, and the control takes two.",
                  "Use two IF, one within the other."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 IF (#g1==1) AND (#g2==2) AND (#g3==3)
N11 THEN
N12 G4 F1
N13 ENDIF
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 IF (#g1==1) AND (#g2==2)
N11 THEN
N12 G4 F1
N13 ENDIF
N99 M30
END
)nc"}},
    .sources = {"SEED-003:19669", "SEED-003:19800"},
    .check = SyntaxErrorKind::too_many_conditions,
};

} // namespace maclint::rules
