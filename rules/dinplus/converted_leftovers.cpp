//! DIN123: a block that a converter left as a remark.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule converted_leftovers{
    .code = "DIN123",
    .name = "converted-leftovers",
    .summary = "A block of an older control was not translated and stands in the program as a remark",
    .why = "What the block did is missing: a shift, a tool or a safe position. The manual warns of a "
           "collision.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"plain", "Block that was not translated: '{0}' does nothing.",
                  "Write what it did in today's words, and delete the remark."}},
    .bad = {{"dinplus", R"nc(
MACHINING
[WARNING N12 G81 X80 Z-20]
N10 G0 X60 Z2
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
[WARNING: the bar turns]
N10 G0 X60 Z2
N99 M30
END
)nc"}},
    .sources = {"SEED-003:10442-10446"},
    .check = SyntaxErrorKind::converted_leftover,
};

} // namespace maclint::rules
