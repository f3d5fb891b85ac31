//! SIN107: remarks of other languages.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule remark_in_parentheses{
    .code = "SIN107",
    .name = "remark-in-parentheses",
    .summary = "A remark stands in ( ), as other languages have it",
    .why = "Remarks begin with ; here. ( ) hold arguments and calculations: the control cannot read "
           "the block, and stops with an alarm.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .needs = {Capability::paired_words},
    .messages = {{"cure", "Remark in parentheses: the control takes '{0}' for code.",
                  "Write a semicolon before its words, in place of the parentheses."},
                 {"plain", "Remark in parentheses: the control takes '{0}' for code.",
                  "Write it at the end of the block, behind a semicolon."}},
    .bad = {{"sinumerik", R"nc(
G17 G90 G54 (FIRST SIDE)
G0 X0 Y0
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
G17 G90 G54 ; (FIRST SIDE)
G0 X0 Y0
M30
)nc"}},
    .alarms = {{"SINUMERIK", "12080", "syntax error at the text shown", false}},
    .sources = {"SEED-004:20-23", "NCP19 p.52"},
    .check = SyntaxErrorKind::foreign_remark,
};

} // namespace maclint::rules
