//! DIN336: a value of the control that there is none of.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule unknown_selector{
    .code = "DIN336",
    .name = "unknown-selector",
    .summary = "A variable of the control is read by a selector that it does not have",
    .why = "The selector says which value is read: with one that is not listed there is none.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"cure", "Unknown selector: '{0}' is in no list.", "Use one of these: {1}."},
                 {"plain", "Unknown selector: '{0}' is in no list."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 #l1=#n95(X)
N11 G4 F#l1
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 #l1=#n95(F)
N11 G4 F#l1
N99 M30
END
)nc"}},
    .sources = {"SEED-003:19032", "SEED-003:19044", "SEED-003:19115-19181", "SEED-003:19235-19321"},
    .check = SyntaxErrorKind::unknown_selector,
};

} // namespace maclint::rules
