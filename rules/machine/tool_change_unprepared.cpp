//! MAC528: a tool change without a tool, a spindle start without a speed.
#include "rules/machine_check.hpp"
#include "rules/path.hpp"

#include <string>

namespace maclint::rules {

namespace {
void check(const MachineStep& at, Reporter& reporter);
}

extern const Rule tool_change_unprepared{
    .code = "MAC528",
    .name = "tool-change-unprepared",
    .summary = "A tool change has no tool, or a spindle is started that has no speed",
    .why = "The change brings back whatever tool was there before; a spindle without a speed stands, or "
           "turns as the program before has left it.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"tool", "Tool change without a tool: no T stands before '{0}'{1}.",
                  "Write T with the number of the tool."},
                 {"speed", "Spindle without a speed: '{0}' starts it, and no S stands before the tool cuts.",
                  "Give S where the spindle is started."},
                 {"no_speed",
                  "Spindle without a speed: '{0}' starts it, and the tool cuts under the S0 of line {1}.",
                  "Give S where the spindle is started."}},
    .bad = {{"fanuc", R"nc(
O9528(PLATE)
G90 G17 G54
T1 M6
S3000 M3
G0 X0 Y0
G43 H1 Z50.
G1 Z-5. F200.
G0 Z50.
M6
S3000 M3
G0 X0 Y0
G43 H2 Z50.
M30
)nc"},
            {"fanuc", R"nc(
O9528(PLATE)
G90 G17 G54
T1 M6
M3
G0 X0 Y0
G43 H1 Z5.
G1 Z-5. F200.
X20.
G0 Z50.
T2 M6
S3000 M3
M30
)nc"},
            {"fanuc", R"nc(
O9528(PLATE)
G90 G17 G54
T1 M6
S0 M3
G0 X0 Y0
G43 H1 Z5.
G1 Z-5. F200.
X20.
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9528(PLATE)
G90 G17 G54
T1
M6
T2
M3
G0 X0 Y0 S3000
G43 H1 Z50.
G1 Z-5. F200.
G0 Z50.
M6
S3000 M3
M30
)nc"}},
    .sources = {"T"},
    .check = MachineCheck{&check},
};

namespace {

void check(const MachineStep& at, Reporter& reporter) {
    if (!at.analysis.is_main()) return;
    const machine::Known& prepared = at.before().prepared;
    if (at.step.changes_tool && !at.step.words.has(at.letters().tool) && at.habits.names_tools() &&
        (prepared.is_callers() || prepared.is(machine::none_prepared))) {
        const bool is_first = prepared.is_callers();
        reporter.report(at.cause(), at.block(), "tool",
                        {at.quoted_block(),
                         is_first ? std::string() : ", after the change of line " + at.line_of(prepared)});
    }
    if (!at.cuts() || !at.is_on(at.after(), ModalRole::spindle)) return;
    const machine::Known& speed = at.after().of(ModalRole::speed);
    const bool none = speed.is_callers();
    // Routers without a word for the speed have none for the tool's length either.
    const bool has_speeds = at.habits.gives_speed() || at.habits.tools_with_length_offset() > 0;
    if (!(none && has_speeds) && !speed.is(0)) return;
    if (!at.is_first_of(speed)) return;
    const Span start = at.block_of(at.after().of(ModalRole::spindle));
    reporter.report({at.analysis, start}, start, none ? "speed" : "no_speed",
                    {quoted(at.analysis.program(), start), at.line_of(speed)});
}

} // namespace
} // namespace maclint::rules
