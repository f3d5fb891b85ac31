//! MAC470: a call whose program comes to its own alarm, whatever happens.
#include "analyzer/dataflow/facts/call_begun.hpp"
#include "rules/calls/call_ends_in_alarm_finder.hpp"
#include "rules/calls/call_ends_in_alarm_words.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule call_ends_in_alarm{
    .code = "MAC470",
    .name = "call-ends-in-alarm",
    .summary = "The called program comes to its own alarm on every path",
    .why =
        "The call leaves out an argument that the program asks for, or passes a number that it refuses, or "
        "the program runs into an alarm that is there for a test. The machine stops there each time, and "
        "what follows the call is never run. Of a program that nobody calls the call is followed "
        "that its own remark shows. A call behind a test, of a program that does nothing but raise alarms, "
        "is meant to stop.",
    .severity = Severity::error,
    .precision = Precision::high,
    .yields_to = "MAC418",
    .facts = dataflow::facts<dataflow::CallBegun>(),
    .data_flow = true,
    .messages =
        {{"left-out", "Call ends in an alarm: '{0}' leaves {1} vacant, and {2} then always comes to {3}.",
          "Pass it."},
         {"order",
          "Call ends in an alarm: of I, J and K in '{0}' one stands behind a later one and counts as a "
          "second one, which leaves {1} vacant; {2} then always comes to {3}.",
          "Write them in this order."},
         {"vacant", "Call ends in an alarm: with what '{0}' leaves out, {2} always comes to {3}.",
          "Pass what it asks for."},
         {"number", "Call ends in an alarm: for the value of {1} at '{0}', {2} always comes to {3}.",
          "Give it another one."},
         {"numbers", "Call ends in an alarm: for the values at '{0}', {2} always comes to {3}.",
          "Give others."},
         {"fallen-in", "Call ends in an alarm: {2} runs into {3} on every path, whatever is passed to it.",
          "End {2} before that, with M99 or a GOTO."},
         {"always", "Call ends in an alarm: {2} comes to {3}, whatever is passed to it.",
          "Delete the call, or correct {2}."}},
    .bad = {{"fanuc", R"nc(
O0001(MAIN)
G65P9470B5.
M30
O9470(MOVE, A B)
IF[#1EQ#0]GOTO99
G91G1X[#1+#2]F200.
G90
M99
N99#3000=101(A MISSING)
)nc"},
            {"fanuc", R"nc(
O0001(MAIN)
G65P9471A5.
M30
O9471(MOVE, A)
IF[#1EQ#0]GOTO99
G91G1X#1F200.
G90
N99#3000=101(A MISSING)
M99
)nc"},
            {"fanuc", R"nc(
O0001(MAIN)
G65P9473D7.
M30
O9473(OFFSET, D FROM 2 TO 5)
IF[#7LT2]GOTO99
IF[#7GT5]GOTO99
G0X[#[2400+#7]]
M99
N99#3000=101(D)
)nc"}},
    .good = {{"fanuc", R"nc(
O0001(MAIN)
IF[#500GT0]GOTO5
G65P9472
N5G65P9470A5.B5.
M30
O9470(MOVE, A B)
IF[#1EQ#0]GOTO99
G91G1X[#1+#2]F200.
G90
M99
N99#3000=101(A MISSING)
O9472(STOP)
#3000=102(NO LENGTH)
)nc"}},
    .exemptions = {{&exemptions::called_to_stop,
                    "called-to-stop",
                    "The called program is there for alarms, and nothing stands behind the call that only it "
                    "leads to: it is called to stop.",
                    {"fanuc", R"nc(
O0470(JOB)
IF[#1001EQ0]GOTO9
G90 G0 X0
M30
N9 G65 P9470
M30
O9470(ALARMS)
#3000=91(NO AIR)
M99
)nc"}}},
    .sources = {"SEED-001:642; T: no control reads on after an alarm"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const AlarmedCall& call : find_alarmed_calls(analysis)) {
        const Span span = call.shown ? *call.shown : program.effects[call.call].span;
        const ProgramAnalysis& stopping = *call.alarm.program;
        const std::string alarm = alarm_of(call);
        const Cause cause = call.shown ? Cause(analysis, span) : Cause(analysis, call.call);
        Finding& finding =
            reporter.report(cause, span, message_for(call),
                            {quoted(program, span), names_of(call), stopping.program().name, alarm});
        if (call.shown)
            finding.severity = Severity::warning; // a remark that has grown old, or a program
        else
            trace(finding, analysis, call.node, "calls " + call.called->program().name);
        add_steps(finding, call);
        finding.same_cause = stopping.program().name + " " + alarm + " " + names_of(call);
    }
}

} // namespace
} // namespace maclint::rules
