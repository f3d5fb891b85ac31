//! SIN601: a synchronised action writes what is calculated ahead.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule action_on_local_variable{
    .code = "SIN601",
    .name = "action-on-local-variable",
    .summary = "A synchronised action stores in an R parameter or a variable of the program",
    .why = "An action runs with the motion, such variables are calculated long before: the control "
           "refuses the store.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"cure",
                  "Variable of the program in a synchronised action: '{0}', where the control stores in {1} "
                  "and the like.",
                  "Write {1}, and read that."}},
    .bad = {{"sinumerik", R"nc(
ID=1 EVERY $A_IN[1]==1 DO R30=$AA_IW[X]
G1 X80 F100
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
ID=1 EVERY $A_IN[1]==1 DO $R[30]=$AA_IW[X]
G1 X80 F100
M30
)nc"}},
    .alarms = {{"SINUMERIK", "12583", "variable in a motion synchronous action is no system variable",
                false}},
    .sources = {"PGA p.344"},
    .check = SyntaxErrorKind::action_on_local,
};

} // namespace maclint::rules
