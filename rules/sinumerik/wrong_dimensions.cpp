//! SIN208: the number of indices of an array.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule wrong_dimensions{
    .code = "SIN208",
    .name = "wrong-dimensions",
    .summary = "A variable has more or fewer indices than its definition",
    .why = "The control stops with an alarm at the block.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"cure", "Wrong number of indices: '{0}', where the definition has {1}.",
                  "Correct the index, or the definition."}},
    .bad = {{"sinumerik", R"nc(
DEF REAL PLACE[4,2]
G0 X=PLACE[1]
M30
)nc"},
            {"sinumerik", R"nc(
DEF REAL DEPTH
G0 Z=DEPTH[0]
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
DEF REAL PLACE[4,2], DEPTH
G0 X=PLACE[1,0] Z=DEPTH
M30
)nc"}},
    .alarms = {{"SINUMERIK", "12400", "array element does not exist", false}},
    .sources = {"JP10 p.23", "FUND06 p.63"},
    .check = SyntaxErrorKind::wrong_dimensions,
};

} // namespace maclint::rules
