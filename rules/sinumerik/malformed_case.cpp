//! SIN123: a table of jumps in a wrong form.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule malformed_case{
    .code = "SIN123",
    .name = "malformed-case",
    .summary = "A CASE lacks the jump behind DEFAULT, or has OF again",
    .why = "The control cannot read the block, and stops with an alarm.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .needs = {Capability::paired_words},
    .messages = {{"cure", "Table of jumps in a wrong form: at '{0}' the control expects {1}."}},
    .bad = {{"sinumerik", R"nc(
CASE R1 OF 1 GOTOF FIRST 2 GOTOF SECOND DEFAULT THIRD
FIRST: G0 X1
SECOND: G0 X2
THIRD: M30
)nc"}},
    .good = {{"sinumerik", R"nc(
CASE R1 OF 1 GOTOF FIRST 2 GOTOF SECOND DEFAULT GOTOF THIRD
FIRST: G0 X1
SECOND: G0 X2
THIRD: M30
)nc"}},
    .alarms = {{"SINUMERIK", "12080", "syntax error at the text shown", false}},
    .sources = {"NCI 4.1.5"},
    .check = SyntaxErrorKind::malformed_case,
};

} // namespace maclint::rules
