//! MAC129: = in a condition, == in an assignment.
#include "analyzer/program/model.hpp"
#include "rules/fixes.hpp"
#include "rules/rule.hpp"

#include <string_view>

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule assignment_for_comparison{
    .code = "MAC129",
    .name = "assignment-for-comparison",
    .summary = "= in a condition, or == where a value is to be stored",
    .why = "= stores and == compares: the control cannot read the block, and stops with an alarm.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .needs = {Capability::paired_words},
    .messages = {{"condition", "Assignment in a condition: '{0}' stores where a value is to be compared.",
                  "Write '{1}'."},
                 {"assignment", "Comparison as a block: '{0}' compares where a value is to be stored.",
                  "Write '{1}'."}},
    .bad = {{"sinumerik", R"nc(
IF R1=1
G0 X60 Z2
ENDIF
M30
)nc"},
            {"sinumerik", R"nc(
R1==40
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
IF R1==1
G0 X60 Z2
ENDIF
R1=40
M30
)nc"}},
    .alarms = {{"SINUMERIK", "12080", "syntax error at the text shown", false}},
    .sources = {"SEED-004:509"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    for (const SyntaxError& error : file.syntax_errors) {
        const bool condition = error.kind == SyntaxErrorKind::assignment_in_condition;
        if (!condition && error.kind != SyntaxErrorKind::comparison_as_assignment) continue;
        Finding& finding =
            reporter.report({file, error.span}, error.span, condition ? "condition" : "assignment",
                            {error.subject, error.cure});
        offer_text(finding, Applicability::unsafe, error.span, condition ? "==" : "=");
    }
}

} // namespace
} // namespace maclint::rules
