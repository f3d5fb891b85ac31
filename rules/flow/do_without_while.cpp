//! MAC318: an endless loop by its form.
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
    .aliases = "",
    .summary = "DO without WHILE from which no GOTO, M99 or alarm leads out",
    .why = "The control repeats the blocks until somebody presses reset.",
    .severity = Severity::warning,
    .precision = Precision::very_high,
    .on_by_default = true,
    .off_reason = "",
    .data_flow = true,
    .messages = {{"plain", "The loop of '{0}' has no condition and no exit, so it never ends. Give it a "
                           "WHILE, or leave it with IF and GOTO."}},
    .bad = {{"fanuc", "O9318(WARM UP)\n"
                      "DO1\n"
                      "G0 X0\n"
                      "G0 X100.\n"
                      "END1\n"
                      "M30\n"}},
    .good = {{"fanuc", "O9318(WARM UP)\n"
                       "#100=0\n"
                       "DO1\n"
                       "G0 X0\n"
                       "G0 X100.\n"
                       "#100=#100+1\n"
                       "IF[#100GE20]GOTO9\n"
                       "END1\n"
                       "N9 M30\n"}},
    .alarms = {},
    .sources = {"SEED-001:411"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const dataflow::Loop& cycle : analysis.inescapable_cycles()) {
        if (!cycle.region || !cycle.exit_edges.empty()) continue;
        const flow::Region& region = analysis.regions().all[*cycle.region];
        if (region.region_kind != RegionKind::endless_loop) continue;
        const Span span = analysis.program().effects[region.open].span;
        Finding& finding =
            reporter.report(analysis.file(), span, "plain", {quoted(analysis.program(), span)});
        trace_round(finding, analysis, cycle, "no condition ends the loop");
    }
}

} // namespace
} // namespace maclint::rules
