//! MAC401: a call that does not say what to call.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule call_without_program_number{
    .code = "MAC401",
    .name = "call-without-program-number",
    .summary = "A macro or subprogram call without P",
    .why = "The control does not know which program to run and stops with an alarm.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .messages = {{"plain",
                  "Call without a program number: '{0}' does not say which program to call, and the control "
                  "stops here.",
                  "Add its number with {1}."}},
    .bad = {{"fanuc", R"nc(
O9401(MAIN)
G65X10.Y5.
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9401(MAIN)
G65P8000X10.Y5.
M30
)nc"},
             {"fanuc", R"nc(
O9402(HAAS CALLS A FILE)
M98 (SUB/HOLES.NC)
M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "076", "ADDRESS P NOT DEFINED"}},
    .sources = {"SEED-001:423"},
    .check = SyntaxErrorKind::call_without_program,
};

} // namespace maclint::rules
