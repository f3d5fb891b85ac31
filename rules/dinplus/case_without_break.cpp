//! DIN410: a branch that may run into the next one.
#include "analyzer/queries/structure/fall_throughs.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <map>
#include <optional>
#include <utility>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule case_without_break{
    .code = "DIN410",
    .name = "case-without-break",
    .summary = "A branch of SWITCH that may run into the next one",
    .why = "BREAK ends a branch. What the control does without it the manual does not say: the blocks of the "
           "next branch may run, too.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"plain", "Missing BREAK: the branch of '{0}' runs into '{1}' on line {2}.",
                  "Add BREAK after its last block."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 INPUT("Size",#l1)
N11 SWITCH #l1
N12 CASE 1
N13 G0 X20
N14 CASE 2
N15 G0 X30
N16 BREAK
N17 ENDSWITCH
N18 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 INPUT("Size",#l1)
N11 SWITCH #l1
N12 CASE 1
N13 G0 X20
N14 BREAK
N15 CASE 2
N16 G0 X30
N17 ENDSWITCH
N18 M30
END
)nc"}},
    .sources = {"SEED-003:19853"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const queries::FallThrough& found : queries::find_fall_throughs(analysis)) {
        const Span span = program.effects[found.branch].span;
        const Span next = program.effects[found.next].span;
        Finding& finding = reporter.report(
            {analysis, found.branch}, span, "plain",
            {quoted(program, span), quoted(program, next), line_number(analysis.file(), next.begin)});
        finding.related.push_back(
            related_at_effect(analysis, found.next, "the branch goes on into this one"));
    }
}

} // namespace
} // namespace maclint::rules
