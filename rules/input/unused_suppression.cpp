//! MAC001: a suppression comment that suppresses nothing. The command raises it once all findings are known.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule unused_suppression{
    .code = "MAC001",
    .name = "unused-suppression",
    .aliases = "",
    .summary = "A suppression comment suppresses nothing",
    .why =
        "An allowance that outlived its cause hides the next real mistake in its place, and tells the reader "
        "of something that is no longer there.",
    .severity = Severity::warning,
    .precision = Precision::very_high,
    .on_by_default = true,
    .off_reason = "",
    .data_flow = false,
    .messages = {{"unused",
                  "'{0}' is allowed here, but there is nothing to allow. Remove it from the comment."},
                 {"comment",
                  "This comment allows '{0}', but there is nothing to allow. Remove the comment."}},
    .bad = {{"fanuc", "O0001(ALLOWS WHAT IS NOT THERE)\n"
                      "G0 X10. (MACLINT ALLOW MAC004 - THE BLOCK WAS LONG ONCE)\n"
                      "M30\n"},
            {"dinplus", "MACHINING\n"
                        "N10 G14 Q0 [MACLINT ALLOW DIN410 - a branch ran on here once]\n"
                        "N20 M30\n"
                        "END\n"}},
    .good = {{"fanuc", "O0001(NO ALLOWANCE)\n"
                       "G0 X10.\n"
                       "M30\n"},
             {"dinplus", "MACHINING\n"
                         "N10 G14 Q0\n"
                         "N20 M30\n"
                         "END\n"}},
    .alarms = {},
    .sources = {"maclint's own: suppression comments, docs/use.md"},
    .check = RaisedByCommand{},
};

} // namespace maclint::rules
