//! DIN307: a number that a variable of whole numbers cannot hold.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule integer_overflow{
    .code = "DIN307",
    .name = "integer-overflow",
    .summary = "A number beyond -32767 to 32767 is stored in one of #g200 to #g299",
    .why = "A variable of whole numbers holds no greater ones: another number is stored, or the control "
           "stops.",
    .severity = Severity::warning,
    .precision = Precision::very_high,
    .messages = {{"cure", "Number too great: '{1}' holds whole numbers from -32767 to 32767, and not '{0}'.",
                  "Use one of #g1 to #g199."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 #g200=70000
N11 G4 F#g200
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 #g100=70000
N11 G4 F#g100
N99 M30
END
)nc"}},
    .sources = {"SEED-003:18888", "SEED-003:18958"},
    .check = SyntaxErrorKind::integer_overflow,
};

} // namespace maclint::rules
