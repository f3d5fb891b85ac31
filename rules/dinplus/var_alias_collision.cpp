//! DIN314: two names of VAR for one variable.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule var_alias_collision{
    .code = "DIN314",
    .name = "var-alias-collision",
    .summary = "Two names of VAR stand for the same variable",
    .why = "Who stores by one name changes the value of the other: most often a number was copied and "
           "not changed.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"cure", "Second name for a variable: '{0}' stands for the same one as '{1}'.",
                  "Give it a variable of its own."}},
    .bad = {{"dinplus", R"nc(
VAR
#_start=#l1(62)
#_end=#l1(40)
MACHINING
N10 G0 X#_start Z2
N11 G0 X#_end
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
VAR
#_start=#l1(62)
#_end=#l2(40)
MACHINING
N10 G0 X#_start Z2
N11 G0 X#_end
N99 M30
END
)nc"}},
    .sources = {"SEED-003:19452-19460"},
    .check = SyntaxErrorKind::doubled_alias,
};

} // namespace maclint::rules
