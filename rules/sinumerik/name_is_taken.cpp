//! SIN114: a name that has a meaning already.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule name_is_taken{
    .code = "SIN114",
    .name = "name-is-taken",
    .summary = "The name of a variable is a word of the language, or another variable has it",
    .why = "A name stands for one thing alone: the control stops with an alarm at the definition.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"cure", "Name that is taken: '{0}' is {1} already.", "Choose another name."}},
    .bad = {{"sinumerik", R"nc(
DEF REAL SPOS
M30
)nc"},
            {"sinumerik", R"nc(
DEF INT ROW
DEF REAL ROW
ROW=2
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
DEF REAL SPOS_1
DEF INT ROW
M30
)nc"}},
    .alarms = {{"SINUMERIK", "12170", "identifier already defined", false}},
    .sources = {"NCP19 p.45"},
    .check = SyntaxErrorKind::taken_name,
};

} // namespace maclint::rules
