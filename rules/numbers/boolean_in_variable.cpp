//! MAC709: a comparison where a value has to be.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule boolean_in_variable{
    .code = "MAC709",
    .name = "boolean-in-variable",
    .summary = "A comparison stands where a value has to be: #1=#2 EQ 5",
    .why = "Only IF and WHILE compare. The control stops at a comparison in an assignment or in a"
           " word. Some makers give it the value 0 or 1.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .yields_to = "MAC122",
    .messages = {{"plain", "Comparison where a value has to be: '{0}', and the control stops here.",
                  "Let IF compare and THEN assign."},
                 {"elsewhere", "Comparison where a value has to be: the assumed control stops at '{0}'.",
                  "Let IF compare and THEN assign, or name the control that takes it (--control {2})."}},
    .bad = {{"fanuc", R"nc(
O9709(FLAG)
#100=#101 EQ 5
M30
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 INPUT("Size",#l2)
N11 #l1=#l2==5
N12 G0 X#l1 Z2
N13 M30
END
)nc"}},
    .good = {{"fanuc", R"nc(
O9709(FLAG)
#100=0
IF[#101EQ5]THEN#100=1
M30
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 INPUT("Size",#l2)
N11 #l1=0
N12 IF #l2==5
N13 THEN
N14 #l1=1
N15 ENDIF
N16 G0 X#l1 Z2
N17 M30
END
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "114", "FORMAT ERROR IN MACRO"},
               {"FANUC 30i/0i-D", "1125", "ILLEGAL EXPRESSION FORMAT"}},
    .sources = {"SINHA-EXP", "HAAS-118", "SEED-003:19643", "SEED-003:19774", "GH-ALM"},
    .check = SyntaxErrorKind::comparison_as_value,
};

} // namespace maclint::rules
