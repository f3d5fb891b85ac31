//! MAC336: blocks that a jump repeats for ever.
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <vector>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule endless_jump_loop{
    .code = "MAC336",
    .name = "endless-jump-loop",
    .aliases = "",
    .summary = "A jump closes a cycle of blocks from which no path leads out and in which nothing can"
               " stop",
    .why = "The control repeats the blocks until somebody presses reset.",
    .severity = Severity::error,
    .precision = Precision::high,
    .on_by_default = true,
    .off_reason = "",
    .data_flow = true,
    .messages = {{"plain",
                  "'{0}' repeats the blocks from line {1} on for ever: no path leads out of them. Count "
                  "the passes, or leave them with IF and GOTO."}},
    .bad = {{"fanuc", "O9336(WAIT)\n"
                      "N10 G0 X0\n"
                      "G0 X100.\n"
                      "GOTO10\n"
                      "M30\n"}},
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
    const flow::Graph& graph = analysis.graph();
    for (const dataflow::Loop& cycle : analysis.inescapable_cycles()) {
        const auto& jump = graph.edges[cycle.back].jump;
        // Loops of the text and conditions that never hold are reported by their own rules.
        if (cycle.region || !jump || !cycle.exit_edges.empty()) continue;
        const Span span = analysis.program().effects[*jump].span;
        Finding& finding =
            reporter.report(analysis.file(), span, "plain",
                            {quoted(analysis.program(), span),
                             line_number(analysis.file(), graph.nodes[cycle.head].part.begin)});
        trace_round(finding, analysis, cycle, "jumps back");
    }
}

} // namespace
} // namespace maclint::rules
