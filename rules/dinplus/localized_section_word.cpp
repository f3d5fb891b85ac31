//! DIN104: section words of two languages in one program.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule localized_section_word{
    .code = "DIN104",
    .name = "localized-section-word",
    .summary = "A section word is of another language than those before it",
    .why = "The control knows the words of the language that it is set to: it takes the other ones for "
           "unknown, and the section for a part of the one before.",
    .severity = Severity::error,
    .precision = Precision::high,
    .messages = {{"cure", "Section word of another language: '{0}' among words of the other one.",
                  "Write {1}."},
                 {"plain", "Section word of another language: '{0}' among words of the other one.",
                  "Write the word of the language of the others."}},
    .bad = {{"dinplus", R"nc(
BLANK
N1 G20 X62 Z100 K1
FERTIGTEIL
N2 G0 X0 Z0
N3 G1 X60
N4 G1 Z-50
MACHINING
N10 T1
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
BLANK
N1 G20 X62 Z100 K1
FINISHED
N2 G0 X0 Z0
N3 G1 X60
N4 G1 Z-50
MACHINING
N10 T1
N99 M30
END
)nc"}},
    .sources = {"SEED-003:2640-2690"},
    .check = SyntaxErrorKind::section_of_other_language,
};

} // namespace maclint::rules
