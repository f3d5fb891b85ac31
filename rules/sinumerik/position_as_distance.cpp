//! SIN505: a position that is used as a distance.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule position_as_distance{
    .code = "SIN505",
    .name = "position-as-distance",
    .summary = "A position that was read is taken as a distance, under G91 or in IC( )",
    .why = "The axis moves by as much as its position is far from zero, and not to that position.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"cure", "Position as a distance: '{0}' moves by the position '{1}', not to it.",
                  "Write AC( ) around it, or G90."}},
    .bad = {{"sinumerik", R"nc(
G0 X100
G91 G1 X=$P_EP[X] F200
G90
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
G0 X100
G90 G1 X=$P_EP[X]+10 F200
M30
)nc"}},
    .sources = {"SEED-004:14-31", "SV"},
    .check = SyntaxErrorKind::position_as_distance,
};

} // namespace maclint::rules
