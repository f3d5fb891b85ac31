//! DIN326: = in a condition, == in an assignment.
#include "analyzer/program/model.hpp"
#include "rules/fixes.hpp"
#include "rules/rule.hpp"

#include <string_view>

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule assign_vs_compare{
    .code = "DIN326",
    .name = "assign-vs-compare",
    .summary = "= in a condition, or == where a value is to be stored",
    .why = "= stores and == compares: the condition does not ask what it seems to ask, and the assignment "
           "stores nothing.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .messages = {{"condition", "Assignment in a condition: '{0}' stores a value where one is to be compared.",
                  "Write '{1}'."},
                 {"assignment",
                  "Comparison as a block: '{0}' compares where a value is to be stored, and stores nothing.",
                  "Write '{1}'."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 INPUT("Size",#l1)
N11 IF #l1=1
N12 THEN
N13 G0 X60 Z2
N14 ENDIF
N15 M30
END
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 #l1==40
N11 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 INPUT("Size",#l1)
N11 IF #l1==1
N12 THEN
N13 G0 X60 Z2
N14 ENDIF
N15 M30
END
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 #l1=40
N11 M30
END
)nc"}},
    .sources = {"SEED-003:19673-19678"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    for (const SyntaxError& syntax_error : file.syntax_errors) {
        const bool condition = syntax_error.kind == SyntaxErrorKind::assignment_in_condition;
        if (!condition && syntax_error.kind != SyntaxErrorKind::comparison_as_assignment) continue;
        Finding& finding = reporter.report({file, syntax_error.span}, syntax_error.span,
                                           condition ? "condition" : "assignment",
                                           {syntax_error.subject, syntax_error.cure});
        offer_text(finding, Applicability::unsafe, syntax_error.span, condition ? "==" : "=");
    }
}

} // namespace
} // namespace maclint::rules
