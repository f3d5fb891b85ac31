//! MAC311: WHILE without its DO.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule while_without_do{
    .code = "MAC311",
    .name = "while-without-do",
    .summary = "WHILE has a condition but no DO",
    .why = "The control stops with a format alarm; the END further down belongs to nothing.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .messages = {{"plain", "Missing DO: '{0}' has none, and the control stops here.", "Add DO1 at its end."},
                 {"cure", "Missing DO: '{0}' has none, and the control stops here.",
                  "Write {1}, with the number of its END."}},
    .bad = {{"fanuc", R"nc(
O9311(ROW)
#100=0
WHILE[#100LT5]
#100=#100+1
END1
M30
)nc"},
            {"fanuc", R"nc(
O9311(ROW)
#100=0
WHILE[#100LT5]GOTO1
#100=#100+1
END1
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9311(ROW)
#100=0
WHILE[#100LT5]DO1
#100=#100+1
END1
M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "125", "FORMAT ERROR IN MACRO"},
               {"FANUC 30i/0i-D", "1138", "WHILE STATEMENT FORMAT ERROR"}},
    .sources = {"SEED-001:395"},
    .check = SyntaxErrorKind::loop_without_do,
};

} // namespace maclint::rules
