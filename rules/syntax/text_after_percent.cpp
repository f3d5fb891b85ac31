//! MAC112: blocks behind the end of the tape.
#include "analyzer/program/faults.hpp"
#include "rules/rule.hpp"
#include "rules/syntax_errors.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule text_after_percent{
    .code = "MAC112",
    .name = "text-after-percent",
    .summary = "Blocks stand behind the % that closes the tape",
    .why = "The control ends reading at the %: a macro behind it is not there when it is called.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"plain", "Blocks behind the end of the tape: the control does not read '{0}'.",
                  "Put them before the %, or into a file of their own."}},
    .bad = {{"fanuc", R"nc(
%
O1112(PLATE)
G90 G0 X0
M30
%
O9112(RETREAT)
G53 Z0
M99
)nc"}},
    .good = {{"fanuc", R"nc(
%
O1112(PLATE)
G90 G0 X0
M30
O9112(RETREAT)
G53 Z0
M99
%
( FILE LENGTH 75 CHARACTERS )
)nc"}},
    .sources = {"T"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    report_syntax_error(file, SyntaxErrorKind::unreadable, reporter,
                        {.severity = Severity::warning, .faults = {faults::behind_tape}});
}

} // namespace
} // namespace maclint::rules
