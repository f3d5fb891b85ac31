//! DIN322: a WINDOW with too many lines.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule window_range{
    .code = "DIN322",
    .name = "window-range",
    .summary = "WINDOW opens more than 20 lines",
    .why = "A window has 0 to 20 lines, and 0 closes it: the control refuses any other number.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .messages = {{"plain", "Lines of a window: '{0}' are none of 0 to 20.",
                  "Write a whole number up to 20."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 WINDOW(25)
N11 PRINT("A")
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 WINDOW(20)
N11 PRINT("A")
N99 M30
END
)nc"}},
    .sources = {"SEED-003:19568"},
    .check = SyntaxErrorKind::window_out_of_range,
};

} // namespace maclint::rules
