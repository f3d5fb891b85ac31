//! MAC312: a loop that is never closed.
#include "analyzer/queries/structure/region_faults.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule do_without_end{
    .code = "MAC312",
    .name = "do-without-end",
    .summary = "DO without its END",
    .why = "The control searches the END to the end of the program, finds none and stops with an"
           " alarm.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .needs = {Capability::loop_numbers},
    .messages = {{"plain", "Missing END: '{0}' is never closed, and the control stops here.",
                  "Add the END after the loop's last block."},
                 {"other-number",
                  "Loop numbers differ: '{0}' has no END, and '{1}' on line {2} closes no loop.",
                  "Give both the same number."}},
    .bad = {{"fanuc", R"nc(
O9312(ROW)
#100=0
WHILE[#100LT5]DO1
#100=#100+1
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9312(ROW)
#100=0
WHILE[#100LT5]DO1
#100=#100+1
END1
M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "124", "MISSING END STATEMENT"},
               {"FANUC 30i/0i-D", "124", "MISSING END STATEMENT"}},
    .sources = {"SEED-001:395", "GH-ALM"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const flow::RegionFault& fault :
         queries::numbered_loop_faults(analysis, flow::Imbalance::never_closed)) {
        const Program& program = analysis.program();
        const Span span = program.effects[fault.effect].span;
        if (!fault.other) {
            reporter.report({analysis, fault.effect}, span, "plain", {quoted(program, span)});
            continue;
        }
        const Span stray = program.effects[*fault.other].span;
        Finding& finding = reporter.report(
            {analysis, fault.effect}, span, "other-number",
            {quoted(program, span), quoted(program, stray), line_number(analysis.file(), stray.begin)});
        finding.related.push_back(related_at_effect(analysis, *fault.other, "this closes no loop"));
    }
}

} // namespace
} // namespace maclint::rules
