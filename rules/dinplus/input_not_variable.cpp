//! DIN329: INPUT without a variable.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule input_not_variable{
    .code = "DIN329",
    .name = "input-not-variable",
    .summary = "INPUT has no variable in which it can store what is typed",
    .why = "INPUT asks with a text and stores the answer in a variable: anything else cannot hold it.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .messages = {{"plain", "No variable for the answer: INPUT stores in '{0}'.",
                  "Write a variable, as in INPUT(\"Diameter\",#l1)."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 INPUT("Diameter",20)
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 INPUT("Diameter",#l1)
N11 G0 X#l1 Z2
N99 M30
END
)nc"}},
    .sources = {"SEED-003:19615"},
    .check = SyntaxErrorKind::input_into_no_variable,
};

} // namespace maclint::rules
