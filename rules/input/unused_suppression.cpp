//! MAC001: a suppression comment that suppresses nothing. The command raises it once all findings are known.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule unused_suppression{
    .code = "MAC001",
    .name = "unused-suppression",
    .summary = "A suppression comment suppresses nothing",
    .why =
        "An allowance that outlived its cause hides the next real mistake in its place, and tells the reader "
        "of something that is no longer there.",
    .severity = Severity::warning,
    .precision = Precision::very_high,
    .messages = {{"unused", "Needless exception: '{0}' is allowed here, but there is nothing to allow.",
                  "Remove it from the comment."},
                 {"comment", "Needless exception: this comment allows '{0}', but there is nothing to allow.",
                  "Remove the comment."}},
    .bad = {{"fanuc", R"nc(
O0001(ALLOWS WHAT IS NOT THERE)
G0 X10. (MACLINT ALLOW MAC004 - THE BLOCK WAS LONG ONCE)
M30
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 G14 Q0 [MACLINT ALLOW DIN410 - a branch ran on here once]
N20 M30
END
)nc"}},
    .good = {{"fanuc", R"nc(
O0001(NO ALLOWANCE)
G0 X10.
M30
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 G14 Q0
N20 M30
END
)nc"}},
    .sources = {"maclint's own: suppression comments, docs/use.md"},
    .check = RaisedByCommand{},
};

} // namespace maclint::rules
