//! SIN201: definitions behind the first block that does something.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule definition_after_code{
    .code = "SIN201",
    .name = "definition-after-code",
    .summary = "DEF or EXTERN stands behind the first block that does something",
    .why = "Variables are defined at the start of a program, behind its PROC: the control stops with "
           "an alarm at a later one.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"cure",
                  "Late definition: '{0}' stands behind '{1}', which is the first block that does something.",
                  "Move it to the start of the program."}},
    .bad = {{"sinumerik", R"nc(
N10 G17 G90 G54
DEF INT HOLE
HOLE=3
G0 X=HOLE
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
DEF INT HOLE
N10 G17 G90 G54
HOLE=3
G0 X=HOLE
M30
)nc"}},
    .alarms = {{"SINUMERIK", "14500", "DEF or PROC at a wrong place", false}},
    .sources = {"T808 p.126"},
    .check = SyntaxErrorKind::late_definition,
};

} // namespace maclint::rules
