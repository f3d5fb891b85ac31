//! DIN306: a fraction in a variable of whole numbers.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule integer_global_fraction{
    .code = "DIN306",
    .name = "integer-global-fraction",
    .summary = "A number with decimals is stored in one of #g200 to #g299, which hold whole numbers",
    .why = "The variable keeps the whole number alone: the decimals are lost, and with them the "
           "position.",
    .severity = Severity::warning,
    .precision = Precision::very_high,
    .messages = {{"cure", "Fraction for a whole number: '{1}' keeps no decimals of '{0}'.",
                  "Use one of #g1 to #g199."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 #g200=2.5
N11 G0 X#g200 Z2
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 #g100=2.5
N11 #g200=2
N12 G0 X#g100 Z#g200
N99 M30
END
)nc"}},
    .sources = {"SEED-003:18958", "SEED-003:18888"},
    .check = SyntaxErrorKind::fraction_for_integer,
};

} // namespace maclint::rules
