//! DIN303: a value is stored in a variable that is kept for others.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule reserved_global{
    .code = "DIN303",
    .name = "reserved-global",
    .summary = "A value is stored in a global variable that the control or the maker of the machine uses",
    .why = "Programs of the maker, measuring cycles and structure programs store there: one overwrites "
           "the value of the other, and it stays when the control is switched off.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"cure", "Variable of others: '{0}' is kept for {1}.", "Use one of #g1 to #g299."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 #g810=0
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 #g20=0
N11 G4 F(#g20+1)
N99 M30
END
)nc"}},
    .sources = {"SEED-003:2723-2726", "SEED-003:22232"},
    .check = SyntaxErrorKind::reserved_variable,
};

} // namespace maclint::rules
