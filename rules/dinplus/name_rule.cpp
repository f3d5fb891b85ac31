//! DIN308: the name of a constant or a variable.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule name_rule{
    .code = "DIN308",
    .name = "name-rule",
    .summary = "The name of a constant or variable is too long, or holds capitals",
    .why = "Names have an underscore, small letters and figures, and at most 20 characters: the control "
           "takes no others.",
    .severity = Severity::error,
    .precision = Precision::high,
    .messages = {{"cure", "Name that may not be: '{0}', because {1}.",
                  "Write it in small letters and figures, with at most 20 of them behind the underscore."}},
    .bad = {{"dinplus", R"nc(
CONST
_SafeDistance=2
MACHINING
N10 G0 X60 Z_SafeDistance
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
CONST
_safe_distance=2
MACHINING
N10 G0 X60 Z_safe_distance
N99 M30
END
)nc"}},
    .sources = {"SEED-003:2957", "SEED-003:2983", "SEED-003:19448-19450"},
    .check = SyntaxErrorKind::malformed_name,
};

} // namespace maclint::rules
