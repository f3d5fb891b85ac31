//! MAC119: a comparison written with signs.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule symbolic_comparison{
    .code = "MAC119",
    .name = "symbolic-comparison",
    .aliases = "",
    .summary = "A comparison is written with = or < instead of EQ or LT",
    .why = "The control knows only the two-letter words: it stops with an alarm when it reaches "
           "the condition.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .on_by_default = true,
    .off_reason = "",
    .data_flow = false,
    .messages = {{"cure", "'{0}' does not compare: the control stops here. Write {1}."},
                 {"plain", "'{0}' does not compare: the control stops here. Use EQ, NE, GT, GE, LT or LE."}},
    .bad = {{"fanuc", "O9119(CHOICE)\n"
                      "IF[#100=2]GOTO5\n"
                      "#100=2\n"
                      "N5 M30\n"}},
    .good = {{"fanuc", "O9119(CHOICE)\n"
                       "IF[#100EQ2]GOTO5\n"
                       "#100=2\n"
                       "N5 M30\n"}},
    .alarms = {{"FANUC 16i/18i/21i", "114", "FORMAT ERROR IN MACRO"}},
    .sources = {"IMD-MAXZ"},
    .check = SyntaxErrorKind::symbolic_comparison,
};

} // namespace maclint::rules
