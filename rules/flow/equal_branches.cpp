//! MAC337: both outcomes of an IF do the same.
#include "rules/flow/equal_branches_finder.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule equal_branches{
    .code = "MAC337",
    .name = "equal-branches",
    .summary = "Both outcomes of an IF do the same",
    .why = "The condition decides nothing. One of the two branches was copied and not changed, or the IF was "
           "left behind when they were changed.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"same",
                  "Condition without effect: the blocks from line {1} on, for '{0}', and those from line {2} "
                  "on, for any other case, do the same.",
                  "Change the branch that was meant to differ, or remove the condition."},
                 {"next-block", "Condition without effect: for '{0}' the jump leads to the block behind it.",
                  "Correct the number of the jump, or remove the condition."}},
    .bad = {{"fanuc", R"nc(
O9337(SIDE, K SIDE X WAY)
IF[#6EQ1]GOTO4
G0 X#24
GOTO5
N4 G0 X#24
N5 M99
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 INPUT("Length",#l1)
N20 IF #l1>100
N30 THEN
N40 G95 F0.5
N50 ELSE
N60 G95 F0.5
N70 ENDIF
N80 G0 X46 Z#l1
N90 M30
END
)nc"}},
    .good = {{"fanuc", R"nc(
O9337(SIDE, K SIDE X WAY)
IF[#6EQ1]GOTO4
G0 X-#24
GOTO5
N4 G0 X#24
N5 M99
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 INPUT("Length",#l1)
N20 IF #l1>100
N30 THEN
N40 G95 F0.5
N50 ELSE
N60 G95 F0.3
N70 ENDIF
N80 G0 X46 Z#l1
N90 M30
END
)nc"}},
    .sources = {"T"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const EqualBranches& equal : find_equal_branches(analysis)) {
        const Span span = program.expressions[equal.condition].span;
        if (equal.if_true.empty()) {
            reporter.report({analysis, equal.effect}, span, "next-block", {quoted(program, span)});
            continue;
        }
        Finding& finding =
            reporter.report({analysis, equal.effect}, span, "same",
                            {quoted(program, span), line_number(analysis.file(), equal.if_true.begin),
                             line_number(analysis.file(), equal.if_false.begin)});
        finding.related.push_back({analysis.source(), equal.if_true, "these blocks run when it is true"});
        finding.related.push_back({analysis.source(), equal.if_false, "and these when it is not"});
    }
}

} // namespace
} // namespace maclint::rules
