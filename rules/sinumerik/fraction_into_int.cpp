//! SIN210: a number with decimals that is stored in an INT.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule fraction_into_int{
    .code = "SIN210",
    .name = "fraction-into-int",
    .summary = "A number with decimals is stored in an INT",
    .why =
        "An INT holds whole numbers: the control rounds what is stored, and the program works with another "
        "number than the one that stands there.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"plain", "Decimals are lost: an INT does not hold '{0}'.",
                  "Write a whole number, or store it in a REAL."}},
    .bad = {{"sinumerik", R"nc(
DEF INT WIDTH_
WIDTH_=2.5
G1 X=WIDTH_ F100
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
DEF INT COUNT_=4.0
DEF REAL WIDTH_
WIDTH_=2.5
G1 X=WIDTH_*COUNT_ F100
M30
)nc"}},
    .sources = {"T"},
    .check = SyntaxErrorKind::fraction_for_integer,
};

} // namespace maclint::rules
