//! SIN408: PROC names another program than its file.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule other_program_name{
    .code = "SIN408",
    .name = "proc-name-is-not-file-name",
    .summary = "The name behind PROC is not that of the file",
    .why = "A call finds the program by the name of its file: a leftover of the program that was "
           "copied misleads who reads it, and a cycle directory takes the name behind PROC.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"cure", "Name of another program: PROC says '{0}', and the program is {1}.", "Write {1}."}},
    .bad = {{"sinumerik", R"nc(
%_N_SLOT_SPF
PROC POCKET(REAL WIDTH)
G0 X=WIDTH
M17
)nc"}},
    .good = {{"sinumerik", R"nc(
%_N_SLOT_SPF
PROC SLOT(REAL WIDTH)
G0 X=WIDTH
M17
)nc"}},
    .sources = {"NCP23 p.490"},
    .check = SyntaxErrorKind::other_program_name,
};

} // namespace maclint::rules
