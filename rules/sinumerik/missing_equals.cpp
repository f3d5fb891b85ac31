//! SIN105: the = behind an address is missing.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule missing_equals{
    .code = "SIN105",
    .name = "missing-equals",
    .summary = "A calculated value, a variable or a text stands behind an address without =",
    .why = "Only a plain number may follow an address of one letter. The control cannot read anything "
           "else, and stops with an alarm.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .needs = {Capability::paired_words},
    .messages = {{"cure", "Missing '=': the control cannot read '{0}', but '{1}'.",
                  "Write = behind the address."}},
    .bad = {{"sinumerik", R"nc(
DEF REAL DEPTH=4
G1 Z-DEPTH F200
M30
)nc"},
            {"sinumerik", R"nc(
T"DRILL_8"
M6
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
DEF REAL DEPTH=4
G1 Z=-DEPTH F200
X10 Y=R1+5
M30
)nc"}},
    .alarms = {{"SINUMERIK", "12080", "syntax error at the text shown", false}},
    .sources = {"O802 p.122", "SEED-004:211-216"},
    .check = SyntaxErrorKind::missing_equals,
};

} // namespace maclint::rules
