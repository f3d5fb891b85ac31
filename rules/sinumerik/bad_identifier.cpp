//! SIN113: names that the control does not take.
#include "analyzer/program/model.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule bad_identifier{
    .code = "SIN113",
    .name = "bad-identifier",
    .summary = "The name of a variable or of a program does not begin with two letters, or is too long",
    .why = "A letter and a figure are a word such as D0 or L1: the control cannot read the name, and "
           "stops with an alarm.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"cure", "Name that may not be: '{0}', because {1}.", "Give it another one."}},
    .bad = {{"sinumerik", R"nc(
DEF REAL L1
L1=5
M30
)nc"},
            {"sinumerik", R"nc(
DEF REAL D0_FAST
G1 X10 F100
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
DEF REAL LENGTH1
LENGTH1=5
M30
)nc"}},
    .alarms = {{"SINUMERIK", "12420", "identifier too long", false}},
    .sources = {"FUND04 p.60", "NCP19 p.491"},
    .check = &check,
};

namespace {

/// Who names one variable so names all of them so.
void check(const ProgramFile& file, Reporter& reporter) {
    for (const SyntaxError& error : file.syntax_errors)
        if (error.kind == SyntaxErrorKind::malformed_name)
            reporter.report({file, error.span}, error.span, "cure", {error.subject, error.cure}).same_cause =
                error.cure;
}

} // namespace

} // namespace maclint::rules
