//! MAC336: blocks that a jump repeats for ever.
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <algorithm>
#include <vector>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule endless_jump_loop{
    .code = "MAC336",
    .name = "endless-jump-loop",
    .aliases = "",
    .summary = "A jump closes a cycle of blocks from which no way leads out and in which nothing can"
               " stop",
    .why = "The control repeats the blocks until somebody presses reset.",
    .severity = Severity::error,
    .precision = Precision::high,
    .on_by_default = true,
    .off_reason = "",
    .data_flow = true,
    .messages = {{"plain",
                  "'{0}' repeats the blocks from line {1} on for ever: no way leads out of them. Count "
                  "the passes, or leave them with IF and GOTO."}},
    .bad = {{"fanuc", "O9336(WAIT)\n"
                      "N10 G0 X0\n"
                      "G0 X100.\n"
                      "GOTO10\n"
                      "M30\n"}},
    .also = {},
    .good = {{"fanuc", "O9336(WAIT)\n"
                       "#100=0\n"
                       "N10 G0 X0\n"
                       "G0 X100.\n"
                       "#100=#100+1\n"
                       "IF[#100LT5]GOTO10\n"
                       "M30\n"}},
    .alarms = {},
    .sources = {"SEED-001:371"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    std::vector<flow::NodeId>
        said; // heads of cycles that are reported; one of the same blocks is the same cause
    for (const dataflow::Loop& loop : analysis.loops()) {
        if (loop.structure || !loop.ways_out.empty() || loop.can_stop || loop.has_unknown_effects) continue;
        const auto in_loop = [&](flow::NodeId node) { return loop.holds(node); };
        if (std::ranges::any_of(said, in_loop)) continue;
        const auto endless = [&](const dataflow::Loop& inner) {
            return inner.structure && inner.ways_out.empty() && loop.holds(inner.head);
        };
        if (std::ranges::any_of(analysis.loops(), endless)) continue; // the loop inside is the cause
        said.push_back(loop.head);
        const flow::Edge& back = analysis.graph().edges[loop.back];
        const flow::Graph& graph = analysis.graph();
        const Span span =
            back.jump ? analysis.program().effects[*back.jump].span : graph.nodes[back.from].part;
        Finding& finding = reporter.report(analysis.file(), span, "plain",
                                           {quoted(analysis.program(), span),
                                            line_number(analysis.file(), graph.nodes[loop.head].part.begin)});
        trace_round(finding, analysis, loop, "jumps back");
    }
}

} // namespace
} // namespace maclint::rules
