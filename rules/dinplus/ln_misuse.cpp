//! DIN515: LN for something else than a block.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule ln_misuse{
    .code = "DIN515",
    .name = "ln-misuse",
    .summary = "LN passes a number that is no block",
    .why = "LN is kept for block numbers: when the program is numbered anew, the control changes its "
           "value.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"cure", "No block: '{0}' passes something else than {1}.",
                  "Use another letter, as LO or LP."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 L"DWELL" V1 LN12.5
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 L"DWELL" V1 LO12.5
N99 M30
END
)nc"}},
    .sources = {"SEED-003:19948"},
    .check = SyntaxErrorKind::number_for_block,
};

} // namespace maclint::rules
