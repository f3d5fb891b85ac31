//! DIN516: a call whose Q is no number of times.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule repeat_count{
    .code = "DIN516",
    .name = "repeat-count",
    .summary = "The Q of a call is no whole number from 1 on",
    .why = "Q says how often the subprogram runs: with 0 it may not run at all, and a fraction means "
           "nothing.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"cure", "Number of runs: '{0}' is not {1}.", "Write how often the subprogram is to run."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 L"DWELL" V1 Q0
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 L"DWELL" V1 Q2
N99 M30
END
)nc"}},
    .sources = {"SEED-003:10399", "SEED-003:19943"},
    .check = SyntaxErrorKind::repeat_count,
};

} // namespace maclint::rules
