//! DIN321: BITSET with a bit or a number that it does not take.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule bitset_range{
    .code = "DIN321",
    .name = "bitset-range",
    .summary = "BITSET asks for a bit beyond 0 to 15, or of a number beyond 0 to 65535",
    .why = "The function has 16 bits: what lies beyond them is never set.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .messages = {{"cure", "Argument out of range: BITSET takes {1}, and not '{0}'.", "Correct it."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 IF 1==BITSET(16,#g1)
N11 THEN
N12 G4 F1
N13 ENDIF
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 IF 1==BITSET(15,#g1)
N11 THEN
N12 G4 F1
N13 ENDIF
N99 M30
END
)nc"}},
    .sources = {"SEED-003:19652-19654"},
    .check = SyntaxErrorKind::bit_out_of_range,
};

} // namespace maclint::rules
