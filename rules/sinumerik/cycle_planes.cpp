//! SIN412: a drilling cycle whose planes and depth contradict each other.
#include "analyzer/queries/calls/brought_cycles.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule cycle_planes{
    .code = "SIN412",
    .name = "cycle-planes-contradict",
    .summary = "A drilling cycle has no depth, or one on the side to which the tool is drawn back",
    .why =
        "The tool drills away from the plane to which it is drawn back (RTP), from the reference plane (RFP) "
        "to the depth (DP, or DPR from there on). Where neither is given, or the depth lies on the side of "
        "RTP, the "
        "cycle stops with an alarm: mostly the sign of the depth is lost.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .needs = {Capability::paired_words},
    .messages = {{"depth",
                  "Depth on the wrong side: '{0}' begins at {1} and goes to {2}, and is drawn back to {3}.",
                  "Correct the depth, or one of the two planes."},
                 {"none", "No depth: '{0}' has neither DP nor DPR.",
                  "Give the fourth argument, or the fifth."}},
    .bad = {{"sinumerik", R"nc(
G17 G90 G54
G0 X10 Y10 Z50
CYCLE82(50,0,2,20,,0.3)
M30
)nc"},
            {"sinumerik", R"nc(
G17 G90 G54
G0 X10 Y10 Z50
CYCLE81(50,0,2)
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
G17 G90 G54
G0 X10 Y10 Z50
CYCLE82(50,0,2,-20,,0.3)
CYCLE82(50,0,2,,20,0.3)
M30
)nc"}},
    .alarms = {{"SINUMERIK", "61101", "cycle: reference plane wrong", false}},
    .sources = {"T: alarm 61101", "SCYC"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const CallSite& site : analysis.calls()) {
        const BroughtCycle* cycle = queries::cycle_called(analysis, site.effect);
        if (cycle == nullptr) continue;
        const Call& call = queries::call_of(program, site.effect);
        const Span span = program.effects[site.effect].span;
        if (queries::is_left_out(program, call, *cycle, "DP") &&
            queries::is_left_out(program, call, *cycle, "DPR")) {
            reporter.report({analysis, site.effect}, span, "none", {quoted(program, span)});
            continue;
        }
        const auto back = queries::number_passed(program, call, *cycle, "RTP");
        const auto from = queries::number_passed(program, call, *cycle, "RFP");
        const auto depth = queries::number_passed(program, call, *cycle, "DP");
        if (!back || !from || !depth) continue;
        const bool is_beside = (*back > *from && *depth > *from) || (*back < *from && *depth < *from);
        if (!is_beside) continue;
        reporter.report({analysis, site.effect}, span, "depth",
                        {quoted(program, span), number_word(*from), number_word(*depth), number_word(*back)});
    }
}

} // namespace
} // namespace maclint::rules
