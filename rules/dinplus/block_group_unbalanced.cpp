//! DIN016: BLOCKSTART without BLOCKEND, or the reverse.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule block_group_unbalanced{
    .code = "DIN016",
    .name = "block-group-unbalanced",
    .summary = "BLOCKSTART and BLOCKEND do not pair in their section",
    .why = "The editor shows what stands between the two as one group: without the other word it shows "
           "the wrong blocks, or cannot read the program.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"cure", "Group that is open on one side: '{0}' lacks its {1}.",
                  "Add it, or delete this one."}},
    .bad = {{"dinplus", R"nc(
MACHINING
BLOCKSTART
N10 G14 Q0
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
BLOCKSTART
N10 G14 Q0
BLOCKEND
N99 M30
END
)nc"}},
    .sources = {"SEED-003:2406"},
    .check = SyntaxErrorKind::group_unbalanced,
};

} // namespace maclint::rules
