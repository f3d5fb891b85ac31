//! SIN120: more auxiliary functions in a block than the control takes.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule too_many_functions{
    .code = "SIN120",
    .name = "too-many-functions",
    .summary = "A block has more M, S or H functions than the control takes",
    .why = "The control hands five M, three S and three H functions of a block to the machine, and stops "
           "with an "
           "alarm where there are more. No public document confirms the numbers.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"cure", "Too many functions in a block: '{0}', and no more than {1} are known to be taken.",
                  "Write it into the next block."}},
    .bad = {{"sinumerik", R"nc(
N10 M3 M8 M41 M21 M25 M31
N20 G0 X10
N30 M30
)nc"}},
    .good = {{"sinumerik", R"nc(
N10 M3 M8 M41 M21 M25
N15 M31
N20 G0 X10
N30 M30
)nc"}},
    .alarms = {{"SINUMERIK", "14750", "too many auxiliary functions in the block", false}},
    .sources = {"T: alarm 14750"},
    .check = SyntaxErrorKind::too_many_functions,
};

} // namespace maclint::rules
