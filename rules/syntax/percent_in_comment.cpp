//! MAC125: a % in a comment.
#include "analyzer/program/faults.hpp"
#include "rules/rule.hpp"
#include "rules/syntax_errors.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule percent_in_comment{
    .code = "MAC125",
    .name = "percent-in-comment",
    .summary = "A comment holds a %",
    .why = "The % is the end of the tape wherever it stands: when the program is read in, the control stores "
           "what stands before it and no more.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"plain", "Percent sign in a comment: '{0}' ends the program when it is read in.",
                  "Write PCT, or leave it out."}},
    .bad = {{"fanuc", R"nc(
%
O9125(FEED 50% AT THE EDGE)
G90 G0 X0
M30
%
)nc"}},
    .good = {{"fanuc", R"nc(
%
O9125(HALF FEED AT THE EDGE)
G90 G0 X0
M30
%
)nc"}},
    .sources = {"T"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    report_syntax_error(file, SyntaxErrorKind::unreadable, reporter,
                        {.severity = Severity::warning, .faults = {faults::percent_in_comment}});
}

} // namespace
} // namespace maclint::rules
