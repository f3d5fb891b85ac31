//! DIN315: the number of a variable is calculated.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule index_is_expression{
    .code = "DIN315",
    .name = "index-is-expression",
    .summary = "The number of a variable is given by a calculation, and not by another variable",
    .why = "A variable alone may give the number of another one, as in #g(#c2): the control refuses a "
           "calculation there.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .messages = {{"cure", "Calculated number of a variable: '{1}' in '{0}'.",
                  "Store it in a variable first, and write that in its place."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 #l1=1
N11 #g5=#g(#l1+1)
N12 G4 F#g5
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 #l1=1
N11 #l2=#l1+1
N12 #g5=#g(#l2)
N13 G4 F#g5
N99 M30
END
)nc"}},
    .sources = {"SEED-003:18891"},
    .check = SyntaxErrorKind::calculated_index,
};

} // namespace maclint::rules
