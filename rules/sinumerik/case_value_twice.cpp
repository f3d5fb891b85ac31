//! SIN304: a value that a CASE has twice.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule case_value_twice{
    .code = "SIN304",
    .name = "case-value-twice",
    .summary = "A CASE names a value twice",
    .why = "The first of the two is taken: what the second jumps to is never done for that value.",
    .severity = Severity::warning,
    .precision = Precision::very_high,
    .needs = {Capability::paired_words},
    .messages = {{"plain", "Value twice in a CASE: '{0}' is never taken.", "Correct one of the two values."}},
    .bad = {{"sinumerik", R"nc(
CASE R1 OF 1 GOTOF FIRST 1 GOTOF SECOND
FIRST: G0 X1
SECOND: M30
)nc"}},
    .good = {{"sinumerik", R"nc(
CASE R1 OF 1 GOTOF FIRST 2 GOTOF SECOND
FIRST: G0 X1
SECOND: M30
)nc"}},
    .sources = {"NCI 4.1.5"},
    .check = SyntaxErrorKind::value_twice,
};

} // namespace maclint::rules
