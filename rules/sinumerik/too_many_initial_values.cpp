//! SIN213: more values than an array has places.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule too_many_initial_values{
    .code = "SIN213",
    .name = "too-many-initial-values",
    .summary = "An array is given more values than it has places",
    .why = "The control stops with an alarm at the block.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"cure", "Too many values: '{0}' gives more than the {1}.",
                  "Remove those that are too many, or make the array larger."}},
    .bad = {{"sinumerik", R"nc(
DEF INT ROW[3]=SET(1,2,3,4)
M30
)nc"},
            {"sinumerik", R"nc(
DEF INT ROW[5]
ROW[3]=SET(1,2,3)
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
DEF INT ROW[4]=SET(1,2,3,4)
M30
)nc"}},
    .alarms = {{"SINUMERIK", "12260", "too many initialisation values", false},
               {"SINUMERIK", "14130", "too many initialisation values", false}},
    .sources = {"HLS", "NCP19 p.404"},
    .check = SyntaxErrorKind::too_many_initial_values,
};

} // namespace maclint::rules
