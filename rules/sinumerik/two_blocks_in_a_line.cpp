//! SIN110: a block number behind words.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule two_blocks_in_a_line{
    .code = "SIN110",
    .name = "two-blocks-in-a-line",
    .summary = "A second block number stands in a line",
    .why = "A line is one block, and its number stands at its head. The control cannot read the rest, "
           "and stops with an alarm.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .needs = {Capability::paired_words},
    .messages = {{"plain", "Two blocks in a line: '{0}' stands behind words.",
                  "Begin a new line before it."}},
    .bad = {{"sinumerik", R"nc(
N10 G0 X10 N20 Y20
N30 M30
)nc"}},
    .good = {{"sinumerik", R"nc(
N10 G0 X10
N20 Y20
N30 M30
)nc"}},
    .alarms = {{"SINUMERIK", "12080", "syntax error at the text shown", false}},
    .sources = {"SEED-004:511"},
    .check = SyntaxErrorKind::second_block,
};

} // namespace maclint::rules
