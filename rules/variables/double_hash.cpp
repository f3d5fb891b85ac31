//! MAC206: two # in a row.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule double_hash{
    .code = "MAC206",
    .name = "double-hash",
    .summary = "An indirect variable is written ##1 instead of #[#1]",
    .why = "The control takes a number, a bracket or a name after #, and stops at the second one.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .yields_to = "MAC122",
    .messages = {{"cure", "Two # in a row: '{0}', and the control stops here.", "Write '{1}'."},
                 {"plain", "Two # in a row: '{0}', and the control stops here.",
                  "Put the inner variable in [ ]."}},
    .bad = {{"fanuc", R"nc(
O9206(TABLE)
#100=120
##100=5.
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9206(TABLE)
#100=120
#[#100]=5.
M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "115", "ILLEGAL VARIABLE NUMBER", false}},
    .sources = {"NCT-173"},
    .check = SyntaxErrorKind::double_sharp,
};

} // namespace maclint::rules
