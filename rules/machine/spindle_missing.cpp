//! MAC554: a cut with a spindle that stands.
#include "rules/machine/sure_cuts.hpp"
#include "rules/machine_check.hpp"
#include "rules/path.hpp"

namespace maclint::rules {

namespace {
void check(const MachineStep& at, Reporter& reporter);
}

extern const Rule spindle_missing{
    .code = "MAC554",
    .name = "spindle-missing",
    .summary = "A tool cuts while the spindle stands",
    .why = "The tool is pushed into the work without turning, and breaks.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages =
        {{"never", "Spindle off: '{0}' cuts, and nothing has started the spindle.",
          "Start it before, with its speed."},
         {"stopped", "Spindle off: '{0}' cuts, and the spindle stands since line {1}.",
          "Start it again before, with its speed."},
         {"changed",
          "Spindle off: '{0}' cuts, and nothing has started the spindle since the tool change of line {1}.",
          "Start it before, with its speed."}},
    .bad = {{"fanuc", R"nc(
O9554(PLATE)
G90 G17 G54
T1 M6
S3000 M3
G43 H1 Z50.
G1 Z-5. F200.
X50.
G0 Z50.
T2 M6
G0 X25. Y25.
G43 H2 Z50. S1200
G81 X25. Y25. Z-12. R2. F100.
G80
M30
)nc"},
            {"fanuc", R"nc(
O9554(PLATE)
G90 G17 G54
T1 M6
S3000 M3
G43 H1 Z50.
G1 Z-5. F200.
X50.
G0 Z50. M5
M0 (TURN THE PART)
X0 Y0
Z5.
G1 Z-5. F200.
X50.
M30
)nc"},
            {"fanuc", R"nc(
O9554(PLATE)
G90 G17 G54
T1 M6
S3000
G43 H1 Z50.
G81 X5. Y5. Z-3. R2. F100.
G80
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9554(DOWEL PIN)
G90 G17 G54
T1 M6
S3000 M3
G43 H1 Z50.
G1 Z-5. F200.
X50.
G0 Z50.
M5
G1 Z-2. F500. (A STOP FOR THE PART)
M0
T2 M6
M13 S1200
G0 X25. Y25.
G43 H2 Z50.
G81 X25. Y25. Z-12. R2. F100.
G80
M30
)nc"},
             {"fanuc", R"nc(
O9554(POCKET, CALLED WITH THE SPINDLE ON)
G91 G1 Z-1. F200.
X10.
G90
M99
)nc"}},
    .sources = {"T"},
    .check = MachineCheck{&check},
};

namespace {

void check(const MachineStep& at, Reporter& reporter) {
    if (!at.cuts() && !at.step.calls) return;
    const std::optional<double> off = at.off(ModalRole::spindle);
    const machine::Known& now = at.after().of(ModalRole::spindle);
    // A stop in the block comes after its move.
    const machine::Known& spindle = now.block == at.block().begin ? at.before().of(ModalRole::spindle) : now;
    if (!off || at.is_on(at.after(), ModalRole::spindle)) return;
    const bool never = spindle.is_callers() && at.analysis.is_main();
    if (!never && !spindle.is(*off)) return;
    if (!at.habits.names_tools() || !(at.habits.turns_spindle() || at.habits.gives_speed())) return;
    const bool calls = calls_what_cuts(at);
    if ((!calls && !is_surely_a_cut(at)) || !at.is_first_of(spindle)) return;
    // Where the tool has gone straight down before, it has cut from there on.
    const bool since_plunge = !calls && at.before().plunged.is(1) && at.step.move == machine::Move::feed;
    const Span place = since_plunge ? at.block_of(at.before().plunged) : at.block();
    const bool by_change = at.after().changed.is_known() && at.after().changed.block == spindle.block;
    Finding& finding = reporter.report(
        {at.analysis, place}, place,
        never       ? "never"
        : by_change ? "changed"
                    : "stopped",
        {since_plunge ? quoted(at.analysis.program(), place) : at.quoted_block(), at.line_of(spindle)});
    if (!never) finding.related.push_back(at.at(spindle, "the spindle stands from here on"));
}

} // namespace
} // namespace maclint::rules
