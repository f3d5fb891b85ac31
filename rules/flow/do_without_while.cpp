//! MAC318: an endless loop by its form.
#include "analyzer/queries/loops/loop_exits.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule do_without_while{
    .code = "MAC318",
    .name = "do-without-while",
    .summary = "DO without WHILE from which no GOTO, M99 or alarm leads out",
    .why = "The control repeats the blocks until somebody presses reset.",
    .severity = Severity::warning,
    .precision = Precision::very_high,
    .data_flow = true,
    .stands_without_path = true,
    .messages = {{"plain", "Endless loop: '{0}' has no condition, and nothing leaves the loop.",
                  "Give it a WHILE, or leave it with IF and GOTO."}},
    .bad = {{"fanuc", R"nc(
O9318(WARM UP)
DO1
G0 X0
G0 X100.
END1
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9318(WARM UP)
#100=0
DO1
G0 X0
G0 X100.
#100=#100+1
IF[#100GE20]GOTO9
END1
N9 M30
)nc"}},
    .sources = {"SEED-001:411"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const dataflow::Loop& cycle : analysis.inescapable_cycles()) {
        const flow::Region* region = queries::region_of(analysis, cycle);
        if (region == nullptr || !cycle.exit_edges.empty()) continue;
        if (region->region_kind != RegionKind::endless_loop) continue;
        const Span span = analysis.program().effects[region->open].span;
        Finding& finding =
            reporter.report({analysis, region->open}, span, "plain", {quoted(analysis.program(), span)});
        trace_round(finding, analysis, cycle, "no condition ends the loop");
    }
}

} // namespace
} // namespace maclint::rules
