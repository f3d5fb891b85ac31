//! SIN602: the number of a synchronised action.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule action_id{
    .code = "SIN602",
    .name = "action-id",
    .summary = "The number of a synchronised action is not one from 1 to 255",
    .why = "The control has no action of that number, and stops with an alarm.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"cure", "Number of an action: '{0}', which may be {1}.", "Choose one of them."}},
    .bad = {{"sinumerik", R"nc(
ID=300 WHENEVER $A_IN[1]==1 DO M8
G1 X80 F100
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
ID=3 WHENEVER $A_IN[1]==1 DO M8
G1 X80 F100
M30
)nc"}},
    .sources = {"PGA p.343"},
    .check = SyntaxErrorKind::action_number,
};

} // namespace maclint::rules
