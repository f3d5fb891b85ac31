//! DIN013: remarks of other languages.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule foreign_comment_style{
    .code = "DIN013",
    .name = "foreign-comment-style",
    .summary = "A remark stands in ( ) or behind ; or //, as other languages have it",
    .why =
        "Remarks stand in [ ]. What stands in ( ) is a calculation, and ; and // begin nothing: the control "
        "marks the block and stops there.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .yields_to = "MAC122",
    .messages = {{"cure", "Remark of another language: '{0}', which the control takes for code.",
                  "Write '{1}'."},
                 {"plain", "Remark of another language: '{0}', which the control takes for code.",
                  "Write it in [ ], or delete it."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 T1
N11 G0 X60 Z2 (rough)
N12 M30
END
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 T1 ; rough
N11 G0 X60 Z2
N12 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 T1
N11 G0 X60 Z2 [rough]
N12 M30
END
)nc"}},
    .sources = {"SEED-003:2249"},
    .check = SyntaxErrorKind::foreign_remark,
};

} // namespace maclint::rules
