//! SIN211: a number that no INT holds.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule int_overflow{
    .code = "SIN211",
    .name = "int-overflow",
    .summary = "A number is stored in an INT that is too large for it",
    .why = "An INT goes to 2147483647: the control stops with an alarm.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"cure", "Number too large: an INT does not hold '{0}', and goes to {1}.",
                  "Store it in a REAL."}},
    .bad = {{"sinumerik", R"nc(
DEF INT COUNT_
COUNT_=3000000000
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
DEF REAL COUNT_
COUNT_=3000000000
M30
)nc"}},
    .alarms = {{"SINUMERIK", "12160", "range of values exceeded", false}},
    .sources = {"T808 p.126"},
    .check = SyntaxErrorKind::integer_overflow,
};

} // namespace maclint::rules
