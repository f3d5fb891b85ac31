//! SIN124: a definition that goes on in the next line.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule split_declaration{
    .code = "SIN124",
    .name = "split-declaration",
    .summary = "PROC, DEF or EXTERN goes on in the next line",
    .why = "A block ends with its line. The control cannot read either half, and stops with an alarm.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .needs = {Capability::paired_words},
    .messages = {{"plain", "Definition on two lines: '{0}' ends with its line.", "Write it in one line."}},
    .bad = {{"sinumerik", R"nc(
PROC SLOT(REAL WIDTH,
REAL DEPTH)
G0 X=WIDTH
M17
)nc"}},
    .good = {{"sinumerik", R"nc(
PROC SLOT(REAL WIDTH, REAL DEPTH)
G0 X=WIDTH Z=DEPTH
M17
)nc"}},
    .alarms = {{"SINUMERIK", "12080", "syntax error at the text shown", false}},
    .sources = {"NCP19 p.43"},
    .check = SyntaxErrorKind::split_declaration,
};

} // namespace maclint::rules
