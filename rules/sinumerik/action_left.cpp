//! SIN603: a subprogram leaves a synchronised action at work.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule action_left{
    .code = "SIN603",
    .name = "action-left",
    .summary = "A subprogram starts a synchronised action, moves, and returns without ending it",
    .why =
        "An action with ID runs on in the program that called, and in all that follow, until CANCEL or the "
        "end of the main program: it acts at moves that it was not written for.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"plain", "Action left at work: '{0}' still runs when the program returns.",
                  "End it with CANCEL before the program returns, or write IDS where it is to run on."}},
    .bad = {{"sinumerik", R"nc(
PROC AIR_BLAST
ID=4 WHENEVER $AA_IW[Z]>1 DO $A_OUT[6]=1
G1 X10 F100
G0 Z50
M17
)nc"}},
    .good = {{"sinumerik", R"nc(
PROC AIR_BLAST
ID=4 WHENEVER $AA_IW[Z]>1 DO $A_OUT[6]=1
G1 X10 F100
G0 Z50
CANCEL(4)
M17
)nc"}},
    .sources = {"PGA p.343"},
    .check = SyntaxErrorKind::action_left,
};

} // namespace maclint::rules
