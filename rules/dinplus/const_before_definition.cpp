//! DIN309: a constant that the definition of another one needs too early.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule const_before_definition{
    .code = "DIN309",
    .name = "const-before-definition",
    .summary = "A constant is calculated from one that nothing before has defined",
    .why = "Definitions are read in the order of the text: the constant has no value yet.",
    .severity = Severity::error,
    .precision = Precision::high,
    .messages = {{"plain", "Constant without a value: nothing before this line defines '{0}'.",
                  "Move its definition before this one, or correct its name."}},
    .bad = {{"dinplus", R"nc(
CONST
_nws=_sd-1
_sd=2
MACHINING
N10 G0 X60 Z_nws
N11 X_sd
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
CONST
_sd=2
_nws=_sd-1
MACHINING
N10 G0 X60 Z_nws
N11 X_sd
N99 M30
END
)nc"}},
    .sources = {"SEED-003:2955"},
    .check = SyntaxErrorKind::constant_too_early,
};

} // namespace maclint::rules
