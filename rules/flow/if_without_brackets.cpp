//! MAC324: a condition that no brackets hold.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule if_without_brackets{
    .code = "MAC324",
    .name = "if-without-brackets",
    .summary = "The condition of an IF or a WHILE stands without its brackets",
    .why = "The control takes a condition only in [ ], and stops in the block.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .yields_to = "MAC122",
    .messages = {{"cure", "Condition without brackets: '{0}', and the control stops here.", "Write '{1}'."},
                 {"plain", "Condition without brackets: '{0}', and the control stops here.",
                  "Put all of it in [ ]."}},
    .bad = {{"fanuc", R"nc(
O9324(CHOICE)
IF #100 EQ 5 GOTO5
G0 X10.
N5 M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9324(CHOICE)
IF [#100 EQ 5] GOTO5
G0 X10.
N5 M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "114", "FORMAT ERROR IN MACRO"},
               {"FANUC 30i/0i-D", "1137", "IF STATEMENT FORMAT ERROR", true, "if-form"},
               {"FANUC 30i/0i-D", "1138", "WHILE STATEMENT FORMAT ERROR", true, "while-form"}},
    .sources = {"SEED-001:300", "HAAS-118", "GH-ALM"},
    .check = SyntaxErrorKind::condition_without_brackets,
};

} // namespace maclint::rules
