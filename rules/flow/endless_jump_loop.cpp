//! MAC336: blocks that a jump repeats for ever.
#include "analyzer/queries/loops/loop_exits.hpp"
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
    .summary = "A jump closes a cycle of blocks from which no path leads out and in which nothing can"
               " stop",
    .why = "The control repeats the blocks until somebody presses reset. A note where all moves of a program "
           "that nobody calls lie in the cycle, and a return stands behind it, which would begin it again as "
           "well: it is told on request, for programs that run an axis in are meant so.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::jumps},
    .data_flow = true,
    .messages = {{"plain",
                  "Endless loop: '{0}' goes back to line {1}, and nothing in between ever leaves it.",
                  "Count the passes, or leave them with IF and GOTO."},
                 {"whole",
                  "Endless program: '{0}' goes back to line {1}, and nothing in between ever leaves it.",
                  "Count the passes, or leave them with IF and GOTO.", true}},
    .bad = {{"fanuc", R"nc(
O9336(WAIT)
N10 G0 X0
G0 X100.
GOTO10
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9336(WAIT)
#100=0
N10 G0 X0
G0 X100.
#100=#100+1
IF[#100LT5]GOTO10
M30
)nc"}},
    .sources = {"SEED-001:371"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const dataflow::Loop& cycle : analysis.inescapable_cycles()) {
        const auto jump = queries::repeated_by(analysis, cycle);
        // Loops of the text and conditions that never hold are reported by their own rules.
        if (!jump || !queries::is_endless_by_jumps(cycle)) continue;
        const Span span = analysis.program().effects[*jump].span;
        const bool is_whole = queries::repeats_whole_program(analysis, cycle);
        Finding& finding =
            reporter.report({analysis, *jump}, span, is_whole ? "whole" : "plain",
                            {quoted(analysis.program(), span),
                             line_number(analysis.file(), analysis.graph().nodes[cycle.head].part.begin)});
        if (is_whole) finding.severity = Severity::note;
        trace_round(finding, analysis, cycle, "jumps back");
    }
}

} // namespace
} // namespace maclint::rules
