//! DIN512: a word of a call that passes nothing.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule unknown_transfer_letter{
    .code = "DIN512",
    .name = "unknown-transfer-letter",
    .summary = "A call has a word that passes no value",
    .why = "A subprogram reads the listed letters alone: the value is lost, and the one that was meant "
           "is missing.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"plain", "Word that passes nothing: '{0}' is no letter of a call.",
                  "Write one of LA to LF, LH to LK, LN to LP, LR, LS, LU, LW to LZ, BS, BE, WS, AC, WC, "
                  "RC, IC, KC, JC, ID or AT."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 L"DWELL" V1 LA2 LG5
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 L"DWELL" V1 LA2 LH5
N99 M30
END
)nc"}},
    .sources = {"SEED-003:19937-19940"},
    .check = SyntaxErrorKind::unknown_call_word,
};

} // namespace maclint::rules
