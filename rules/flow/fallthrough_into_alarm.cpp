//! MAC461: a program that runs into its own alarm.
#include "analyzer/dataflow/solver/alarm_end.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/queries/machine/changing_values.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <algorithm>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule fallthrough_into_alarm{
    .code = "MAC461",
    .name = "fallthrough-into-alarm",
    .summary = "A program runs into the alarm that is there for its tests",
    .why = "Before the alarm an M99, an M30 or a GOTO is missing: after its work the machine stops with a "
           "message "
           "that does not apply, every time. Where calls of the program are known, MAC470 tells it there.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .data_flow = true,
    .messages = {{"plain",
                  "Alarm on every run: the blocks before '{0}' run into it, and no path ends otherwise.",
                  "Write M99, M30 or a GOTO in front of it."}},
    .bad = {{"fanuc", R"nc(
O9461(MOVE, A)
IF[#1EQ#0]GOTO99
G91G1X#1F200.
G90
N99#3000=101(A MISSING)
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9461(MOVE, A)
IF[#1EQ#0]GOTO99
G91G1X#1F200.
G90
M99
N99#3000=101(A MISSING)
)nc"}},
    .sources = {"SEED-002:319"},
    .check = &check,
};

namespace {

/// Whether it asks for signals or positions: such a program is called to check them, and not to show the
/// alarm of a number that it is given.
bool asks_the_machine(const ProgramAnalysis& analysis) {
    return std::ranges::any_of(analysis.graph().edges, [&](const flow::Edge& edge) {
        return edge.condition && queries::reads_what_changes(analysis, *edge.condition);
    });
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const dataflow::AlarmEnd& end = analysis.summary().alarm_end;
    if (!(end.by_mistake || (end.in_text && asks_the_machine(analysis))) || queries::knows_callers(analysis))
        return;
    for (const flow::Exit& exit : analysis.graph().exits) {
        if (exit.kind != flow::ExitKind::alarm || !dataflow::is_fallen_into(analysis.graph(), exit)) continue;
        const Span stop = analysis.program().effects[*exit.effect].span;
        const Span text{stop.begin, analysis.graph().nodes[exit.node].part.end};
        Finding& finding =
            reporter.report({analysis, *exit.effect}, stop, "plain", {quoted(analysis.program(), text)});
        trace(finding, analysis, exit.node, "the alarm");
        return;
    }
}

} // namespace
} // namespace maclint::rules
