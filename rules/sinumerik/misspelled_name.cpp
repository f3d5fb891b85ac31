//! SIN203: a name that is one letter off a variable.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule misspelled_name{
    .code = "SIN203",
    .name = "misspelled-name",
    .summary = "A name that the program does not define is one letter off one that it defines",
    .why = "The control does not find the name, and stops with an alarm, or it is a variable of the "
           "machine that has another value.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"cure", "Name that is defined nowhere here: '{0}' is one letter off '{1}'.",
                  "Correct the one or the other."}},
    .bad = {{"sinumerik", R"nc(
DEF REAL LENGTH_1
LENGTH_1=5
G1 X=LENGTHH_1 F100
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
DEF REAL LENGTH_1
LENGTH_1=5
G1 X=LENGTH_1 Y=LENGTH_2 F100
M30
)nc"}},
    .sources = {"NCP19 p.404"},
    .check = SyntaxErrorKind::undeclared_name,
};

} // namespace maclint::rules
