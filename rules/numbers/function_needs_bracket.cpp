//! MAC706: a function whose argument stands without brackets.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule function_needs_bracket{
    .code = "MAC706",
    .name = "function-needs-bracket",
    .summary = "The argument of a function stands without its brackets: SIN 30",
    .why = "The control takes the argument of a function only in [ ], and stops in the block. Some"
           " makers take a number or a variable without them.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .yields_to = "MAC122",
    .messages = {{"cure", "Function without brackets: '{0}', and the control stops here.", "Write '{1}'."},
                 {"plain", "Function without brackets: '{0}', and the control stops here.",
                  "Put its argument in [ ]."},
                 {"elsewhere", "Function without brackets: the assumed control stops at '{0}'.",
                  "Put its argument in [ ], or name the control that takes it (--control {2})."}},
    .bad = {{"fanuc", R"nc(
O9706(ANGLE)
#100=SIN 30
#101=ABS#100
G0 X#101
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9706(ANGLE)
#100=SIN[30]
#101=ABS[#100]
G0 X#101
M30
)nc"},
             {"nct", R"nc(
O9706(ANGLE)
#100=SIN 30
#101=ABS#100
G0 X#101
M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "114", "FORMAT ERROR IN MACRO"},
               {"FANUC 30i/0i-D", "1125", "ILLEGAL EXPRESSION FORMAT"}},
    .sources = {"SEED-001:263", "NCT-188", "SEED-002:354", "GH-ALM"},
    .check = SyntaxErrorKind::function_without_brackets,
};

} // namespace maclint::rules
