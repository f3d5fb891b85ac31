//! MAC119: a comparison written with signs.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule symbolic_comparison{
    .code = "MAC119",
    .name = "symbolic-comparison",
    .summary = "A comparison is written with = or < instead of EQ or LT",
    .why = "The control knows only the two-letter words: it stops with an alarm when it reaches "
           "the condition.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .yields_to = "MAC122",
    .messages = {{"cure", "Sign '{0}' does not compare: the control stops here.", "Write {1}."},
                 {"plain", "Sign '{0}' does not compare: the control stops here.",
                  "Use EQ, NE, GT, GE, LT or LE."}},
    .bad = {{"fanuc", R"nc(
O9119(CHOICE)
IF[#100=2]GOTO5
#100=2
N5 M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9119(CHOICE)
IF[#100EQ2]GOTO5
#100=2
N5 M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "114", "FORMAT ERROR IN MACRO"},
               {"FANUC 30i/0i-D", "1125", "ILLEGAL EXPRESSION FORMAT"},
               {"SINUMERIK", "12080", "syntax error at the text shown", false}},
    .sources = {"IMD-MAXZ", "GH-ALM"},
    .check = SyntaxErrorKind::symbolic_comparison,
};

} // namespace maclint::rules
