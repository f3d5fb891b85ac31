//! DIN311: a value stored in a constant.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule const_reassigned{
    .code = "DIN311",
    .name = "const-reassigned",
    .summary = "A value is stored in a constant outside of CONST",
    .why = "A constant has the value that CONST gives it: nothing can be stored in it later.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .messages = {{"plain", "Constant on the left: '{0}' can hold no other value.",
                  "Use a variable: #_name of VAR, or #l1."}},
    .bad = {{"dinplus", R"nc(
CONST
_sd=2
MACHINING
N10 _sd=3
N11 G0 X60 Z_sd
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
VAR
#_sd=#l1(2)
MACHINING
N10 #_sd=3
N11 G0 X60 Z#_sd
N99 M30
END
)nc"}},
    .sources = {"SEED-003:2953", "SEED-003:19495-19499"},
    .check = SyntaxErrorKind::constant_stored,
};

} // namespace maclint::rules
