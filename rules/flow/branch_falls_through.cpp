//! MAC339: one branch of a table of jumps goes on into the next.
#include "rules/flow/branch_falls_through_finder.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule branch_falls_through{
    .code = "MAC339",
    .name = "branch-falls-through",
    .summary = "One branch of a table of jumps goes on into the next one, and the others do not",
    .why = "A GOTO is missing at its end: what is meant for the next case is done as well.",
    .severity = Severity::note,
    .precision = Precision::high,
    .messages = {{"falls",
                  "Branch runs on: the branch from '{0}' on goes on into '{1}' on line {2}; others end with "
                  "'{3}'.",
                  "Write the jump at its end; where it is meant to run on, allow the finding there."}},
    .bad = {{"fanuc", R"nc(
O9339(PART, A IS ITS KIND)
IF[#1EQ1]GOTO10
IF[#1EQ2]GOTO20
IF[#1EQ3]GOTO30
GOTO90
N10 G0 X10.
GOTO90
N20 G0 X20.
N30 G0 X30.
GOTO90
N90 M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9339(PART, A IS ITS KIND)
IF[#1EQ1]GOTO10
IF[#1EQ2]GOTO20
IF[#1EQ3]GOTO30
GOTO90
N10 G0 X10.
GOTO90
N20 G0 X20.
GOTO90
N30 G0 X30.
GOTO90
N90 M99
)nc"},
             {"fanuc", R"nc(
O9338(TWO KINDS THAT ARE MADE ALIKE)
IF[#1EQ1]GOTO10
IF[#1EQ2]GOTO20
IF[#1EQ3]GOTO30
GOTO90
N10 G0 X10.
GOTO90
N20
N30 G0 X30.
GOTO90
N90 M99
)nc"},
             {"fanuc", R"nc(
O9339(STEPS FROM A ON)
IF[#1EQ1]GOTO10
IF[#1EQ2]GOTO20
IF[#1EQ3]GOTO30
GOTO90
N10 G0 X10.
N20 G0 X20.
N30 G0 X30.
N90 M99
)nc"}},
    .sources = {"T"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const FallingBranch& branch : find_falling_branches(analysis)) {
        Finding& finding = reporter.report({analysis, branch.label}, branch.label, "falls",
                                           {quoted(program, branch.label), quoted(program, branch.next),
                                            line_number(analysis.file(), branch.next.begin),
                                            quoted(program, branch.leaves)});
        finding.related.push_back(related_at_effect(analysis, branch.jump, "the jump to it"));
        finding.related.push_back({analysis.source(), branch.next, "it goes on here"});
        finding.related.push_back({analysis.source(), branch.leaves, "another branch leaves so"});
    }
}

} // namespace
} // namespace maclint::rules
