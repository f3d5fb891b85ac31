//! MAC005: a program for a control that maclint does not know. The command raises it once a file is read.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule other_control{
    .code = "MAC005",
    .name = "other-control",
    .summary = "The program is written for another control; what it says here is withheld",
    .why = "Read in the wrong language, every block looks like a mistake, and what the rest finds means"
           " nothing. Two different marks of another control tell it, four remarks after ';', which some "
           "controls"
           " have, or more than a fifth of the blocks, ten at least, that make no sense. Whoever names the "
           "dialect, or allows this finding, sees all others.",
    .severity = Severity::warning,
    .precision = Precision::very_high,
    .messages = {{"marks",
                  "Program for another control: it seems to be for {0} ({1}). Read as {2} it gives {3}, "
                  "withheld here.",
                  "Leave the file out (\"exclude\" in the configuration), or see them with --dialect {2}."},
                 {"share",
                  "Program for another control: {0} blocks cannot be read ({1}). Read as {2} it gives {3}, "
                  "withheld here.",
                  "Leave the file out (\"exclude\" in the configuration), or see them with --dialect {2}."}},
    .bad = {{"fanuc", R"nc(
O0005(PROBE IN X)
#100=R_SKIP[1]
IF[#100EQ0]GOTO9
W_G53G59_COOR[1,1]=#100
N9 M99
)nc"}},
    .good = {{"fanuc", R"nc(
O0005(FIVE SLIPS OF THE PEN ARE NO OTHER CONTROL)
#100=#5061
IF[#100EQ0]GOTO9
#101=#100
N9 M99
)nc"}},
    .sources = {"maclint's own: the signatures of languages"},
    .check = RaisedByCommand{},
};

} // namespace maclint::rules
