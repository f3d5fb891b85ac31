//! DIN312: a name that neither VAR nor CONST declares.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule undeclared_name{
    .code = "DIN312",
    .name = "undeclared-name",
    .summary = "A name is used that neither VAR nor CONST of the program declares",
    .why = "The name stands for no variable and has no value: it is misspelt, or its line is missing.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"plain", "Name without a declaration: '{0}' stands in neither VAR nor CONST.",
                  "Declare it there, or correct the name."}},
    .bad = {{"dinplus", R"nc(
VAR
#_start=#l1(62)
MACHINING
N10 G0 X#_strat Z2
N11 X#_start
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
VAR
#_start=#l1(62)
MACHINING
N10 G0 X#_start Z2
N99 M30
END
)nc"}},
    .sources = {"SEED-003:2978-2997", "SEED-003:19452-19491"},
    .check = SyntaxErrorKind::undeclared_name,
};

} // namespace maclint::rules
