//! SIN305: the part that is to be repeated is not there, or is repeated no times.
#include "rules/rule.hpp"
#include "rules/syntax_errors.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule repetition_marks{
    .code = "SIN305",
    .name = "repetition-marks",
    .summary = "REPEAT names a part that is not there or has its end before its start, or repeats nothing",
    .why =
        "The control searches the part, does not find it, and stops with an alarm. P says how often the part"
        " runs again.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"missing", "Missing label: the part '{0}' that is to be repeated is not there.",
                  "Add the label, or correct the name."},
                 {"order",
                  "Part the wrong way round: in '{0}' the end stands before '{1}', where the part begins.",
                  "Exchange the two labels."},
                 {"passes", "Part that is repeated no times: '{0}' counts how often it runs again.",
                  "Write a number from {1} on."}},
    .bad = {{"sinumerik", R"nc(
PAD: G1 X10
G0 X0
REPEAT PADS P=3
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
PAD: G1 X10
G0 X0
REPEAT PAD P=3
M30
)nc"}},
    .alarms = {{"SINUMERIK", "14082", "label not found in the program part", false},
               {"SINUMERIK", "14013", "number of passes invalid", false}},
    .sources = {"HLS"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    report_syntax_error(file, SyntaxErrorKind::mark_missing, reporter,
                        {.with_cure = "order", .without = "missing"});
    report_syntax_error(file, SyntaxErrorKind::passes_out_of_range, reporter,
                        {.with_cure = "passes", .severity = Severity::warning});
}

} // namespace
} // namespace maclint::rules
