//! MAC457: a called program that ends the job instead of returning.
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/queries/paths/exits.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <algorithm>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);

constexpr Exemption last_call;
} // namespace

extern const Rule end_in_subprogram{
    .code = "MAC457",
    .name = "m30-in-subprogram",
    .aliases = "DIN517",
    .summary =
        "A called program never returns: all its paths end in M30 or M02, and the blocks after the call "
        "never run",
    .why =
        "M30 ends the whole job, not only the program in which it stands: a program that ran on its own is "
        "called now, and the rest of its caller is left out without an alarm.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .data_flow = true,
    .messages = {{"ends",
                  "End in a called program: {0} calls {1} on line {2}, and '{3}' ends the whole job there.",
                  "Return with {4} instead."}},
    .bad = {{"fanuc", R"nc(
O0001(MAIN)
M98 P9457
G0 X0 Y0
M30
O9457(DRILL)
G90 G1 Z-5. F100.
M30
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 L"CHAMFER" LA50
N15 G0 X0
N20 M30
SUBPROGRAM "CHAMFER"
N30 G0 X#__la
N40 M30
RETURN
END
)nc"}},
    .good = {{"fanuc", R"nc(
O0001(MAIN)
M98 P9457
G0 X0 Y0
M30
O9457(DRILL)
IF[#5003GT100.]GOTO9
G90 G1 Z-5. F100.
M99
N9 M30(NOBODY KNOWS WHERE THE TOOL IS)
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 L"CHAMFER" LA50
N15 G0 X0
N20 M30
SUBPROGRAM "CHAMFER"
N30 G0 X#__la
RETURN
END
)nc"}},
    .exemptions = {{&last_call,
                    "nothing-behind-the-call",
                    "Nothing but an end stands behind the call: the job is over there anyway.",
                    {"fanuc", R"nc(
O0457(JOB)
G90 G0 X0
M98 P1457
M30
O1457(LAST PART)
G90 G0 Z50.
M30
)nc"}}},
    .sources = {"T", "SEED-003:20016"},
    .check = &check,
};

namespace {

/// Whether nothing but an end stands behind the call. No edge leads on from a call that never comes back.
bool is_last(const ProgramAnalysis& calling, flow::NodeId call) {
    const flow::NodeId next = call + 1;
    return next == calling.graph().nodes.size() || !calling.graph().exits_at(next).empty();
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    const flow::Exit* end = nullptr;
    for (const flow::Exit& exit : analysis.graph().exits) {
        if (!analysis.data().reached(exit.node) || exit.kind == flow::ExitKind::alarm) continue;
        if (exit.kind != flow::ExitKind::ends) return;
        if (end == nullptr) end = &exit;
    }
    if (end == nullptr || queries::find_reached_caller(analysis) == nullptr) return;
    const auto caller = std::ranges::find_if(analysis.callers(), [&](const Caller& one) {
        const ProgramAnalysis& program_of_call = queries::calling_program(analysis, one);
        const auto call = program_of_call.graph().node_of(one.effect);
        return call && program_of_call.data().reached(*call) && queries::is_of_one_control(analysis, one) &&
               !(last_call.is_on() && is_last(program_of_call, *call));
    });
    if (caller == analysis.callers().end()) return;
    const ProgramAnalysis& calling = queries::calling_program(analysis, *caller);
    const Span span = queries::span_of_exit(analysis, *end);
    const Offset line = calling.program().effects[caller->effect].span.begin;
    Finding& finding =
        reporter.report({analysis, span}, span, "ends",
                        {calling.program().name, program.name, line_number(calling.file(), line),
                         quoted(program, span), std::string(analysis.control().return_word)});
    finding.path.push_back(related_at_effect(calling, caller->effect, "calls " + program.name));
    trace(finding, analysis, end->node, "the job ends here");
}

} // namespace
} // namespace maclint::rules
