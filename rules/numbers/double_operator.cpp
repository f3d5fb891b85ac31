//! MAC716: two signs in a row.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule double_operator{
    .code = "MAC716",
    .name = "double-operator",
    .summary = "Two signs stand in a row: #2--#3",
    .why = "After + or - the control takes a value, and stops at a second sign. It stands between"
           " brackets: #2-[-#3].",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .yields_to = "MAC122",
    .messages = {{"cure", "Two signs in a row: the control stops at '{0}'.", "Write '{1}', or one sign."},
                 {"plain", "Two signs in a row: the control stops at '{0}'.",
                  "Put the second sign and its value in [ ], or write one sign."}},
    .bad = {{"fanuc", R"nc(
O9716(SUM)
#100=#101++#102
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9716(SUM)
#100=#101-[-#102]
#103=-#100
M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "114", "FORMAT ERROR IN MACRO"},
               {"FANUC 30i/0i-D", "1125", "ILLEGAL EXPRESSION FORMAT"}},
    .sources = {"GH-ALM", "T: no manual at hand shows it"},
    .check = SyntaxErrorKind::sign_after_sign,
};

} // namespace maclint::rules
