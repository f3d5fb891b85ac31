//! MAC102: a comment that nobody closes.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule unterminated_comment{
    .code = "MAC102",
    .name = "unterminated-comment",
    .aliases = "DIN012",
    .summary = "A comment is opened and not closed: the rest of the block is swallowed",
    .why = "Whatever stands after the open bracket is text for the control: a word or a whole "
           "statement that the author counts on is never executed. Some controls swallow the "
           "following blocks, too.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .yields_to = "MAC122",
    .messages = {{"plain",
                  "Comment without its end: '{0}' is never closed, so all that it takes in does nothing.",
                  "Close it with '{1}'."}},
    .bad = {{"fanuc", R"nc(
O9102(PART)
#100=5.(DIAMETER
M30
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 G0 X100 Z2 [free of the jaws
N20 G14 Q0
N30 M30
END
)nc"}},
    .good = {{"fanuc", R"nc(
O9102(PART)
#100=5.(DIAMETER)
M30
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 G0 X100 Z2 [free of the jaws]
N20 G14 Q0
N30 M30
END
)nc"}},
    .sources = {"T: the reaction of the control is not documented"},
    .check = SyntaxErrorKind::unterminated_comment,
};

} // namespace maclint::rules
