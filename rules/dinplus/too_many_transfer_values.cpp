//! DIN511: a call that passes more than 29 values.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule too_many_transfer_values{
    .code = "DIN511",
    .name = "too-many-transfer-values",
    .summary = "A call passes more than 29 values",
    .why = "A subprogram has at most 29 transfer values: the control takes no more.",
    .severity = Severity::error,
    .precision = Precision::high,
    .also = "MAC559",
    .messages = {{"cure", "Too many transfer values: '{0}' is one more than {1}.",
                  "Pass fewer, or store some in #g or #c before."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 L"A" V1 LA1 LB2 LC3 LD4 LE5 LF6 LH7 LI8 LJ9 LK1 LN2 LO3 LP4 LR5 LS6 LU7 LW8 LX9 LY1 LZ2 BS3 BE4 WS5 AC6 WC7 RC8 IC9 KC1 JC2 LA3
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 L"A" V1 LA1 LB2 LC3
N99 M30
END
)nc"}},
    .sources = {"SEED-003:19936"},
    .check = SyntaxErrorKind::too_many_arguments,
};

} // namespace maclint::rules
