//! DIN019: a number with more figures than the control keeps.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule number_out_of_format{
    .code = "DIN019",
    .name = "number-out-of-format",
    .summary = "A number has more than ten figures before its point or seven behind it",
    .why = "The control keeps no more figures: it calculates with another number, or refuses the block.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"cure", "Number with too many figures: '{0}', where {1} are the most.", "Round it."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 #l1=62.123456789
N11 G0 X#l1 Z2
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 #l1=62.1234568
N11 G0 X#l1 Z2
N99 M30
END
)nc"}},
    .sources = {"SEED-003:18889"},
    .check = SyntaxErrorKind::number_too_long,
};

} // namespace maclint::rules
