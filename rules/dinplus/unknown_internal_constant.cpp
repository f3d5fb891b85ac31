//! DIN337: an internal constant that there is none of.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule unknown_internal_constant{
    .code = "DIN337",
    .name = "unknown-internal-constant",
    .summary = "An internal constant is not in the list of the control",
    .why = "The control gives values to the listed ones alone: the constant has none.",
    .severity = Severity::error,
    .precision = Precision::high,
    .messages = {{"plain", "Unknown internal constant: '{0}' is not in the list of the control.",
                  "Use one of the list, as __n0_x, __n0_z, __n95_f or __n97_s, or read #n."}},
    .bad = {{"dinplus", R"nc(
CONST
_pos=__n0_q
MACHINING
N10 G0 X60 Z_pos
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
CONST
_pos=__n0_z
MACHINING
N10 G0 X60 Z_pos
N99 M30
END
)nc"}},
    .sources = {"SEED-003:19505-19525"},
    .check = SyntaxErrorKind::unknown_internal_constant,
};

} // namespace maclint::rules
