//! DIN413: SWITCH without a variable.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule switch_not_variable{
    .code = "DIN413",
    .name = "switch-not-variable",
    .summary = "SWITCH asks for a calculation, and not for a variable",
    .why = "The manual has a variable behind SWITCH, whose value the branches name: of anything else it "
           "says nothing.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"plain", "No variable: SWITCH asks for '{0}'.",
                  "Store it in a variable before, and ask for that."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 SWITCH #g1+1
N11 CASE 1
N12 G4 F1
N13 BREAK
N14 ENDSWITCH
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 SWITCH #g1
N11 CASE 1
N12 G4 F1
N13 BREAK
N14 ENDSWITCH
N99 M30
END
)nc"}},
    .sources = {"SEED-003:19850"},
    .check = SyntaxErrorKind::selection_of_calculation,
};

} // namespace maclint::rules
