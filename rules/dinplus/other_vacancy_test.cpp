//! DIN338: DVDEF for a transfer value, DEF for an internal constant.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule other_vacancy_test{
    .code = "DIN338",
    .name = "other-vacancy-test",
    .summary = "DVDEF asks for something that is no internal constant, or DEF and NDEF for one",
    .why = "DVDEF asks whether an internal constant has a value, DEF and NDEF whether a transfer value, "
           "a variable or a constant has one: the other test answers something else.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"cure", "Other test: '{0}' asks for what it is not made for.", "Write '{1}'."},
                 {"plain", "Other test: '{0}' asks for what it is not made for."}},
    .bad = {{"dinplus", R"nc(
%DWELL.ncs
MACHINING
N1 IF DVDEF(__la)
N2 THEN
N3 G4 F#__la
N4 ENDIF
RETURN
)nc"}},
    .good = {{"dinplus", R"nc(
%DWELL.ncs
MACHINING
N1 IF DEF(__la)
N2 THEN
N3 G4 F#__la
N4 ENDIF
RETURN
)nc"}},
    .sources = {"SEED-003:19734-19738"},
    .check = SyntaxErrorKind::other_vacancy_test,
};

} // namespace maclint::rules
