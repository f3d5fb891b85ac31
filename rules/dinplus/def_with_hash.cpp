//! DIN323: DEF, NDEF or DVDEF with a # before the name.
#include "rules/rule.hpp"
#include "rules/syntax_errors.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule def_with_hash{
    .code = "DIN323",
    .name = "def-with-hash",
    .summary = "DEF, NDEF and DVDEF take a name without #",
    .why = "The manual asks for the bare name. With the # the control may ask for the variable whose number "
           "the value is, and the test answers another question. A variable without a name keeps its #: "
           "NDEF(#l1).",
    .severity = Severity::warning,
    .precision = Precision::very_high,
    .messages = {{"cure", "Name with #: '{0}' takes the name without it.", "Write '{1}'."},
                 {"plain", "Name with #: '{0}' takes the name without it.", "Remove the #."}},
    .bad = {{"dinplus", R"nc(
%FACE.ncs
MACHINING
N1 IF DEF(#__la)
N2 THEN
N3 G0 X#__la
N4 ENDIF
RETURN
)nc"}},
    .good = {{"dinplus", R"nc(
%FACE.ncs
MACHINING
N1 IF DEF(__la)
N2 THEN
N3 G0 X#__la
N4 ENDIF
RETURN
)nc"}},
    .sources = {"SEED-003:19732", "SEED-003:22299 (NDEF(#l1))"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    report_syntax_error(file, SyntaxErrorKind::hash_in_vacancy_test, reporter);
}

} // namespace
} // namespace maclint::rules
