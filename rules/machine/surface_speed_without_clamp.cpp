//! MAC570: constant surface speed before anything says how fast the spindle may turn at most.
#include "rules/machine_check.hpp"
#include "rules/path.hpp"

namespace maclint::rules {

namespace {
void check(const MachineStep& at, Reporter& reporter);
}

extern const Rule surface_speed_without_clamp{
    .code = "MAC570",
    .name = "surface-speed-without-clamp",
    .summary = "A lathe works under constant surface speed before its highest spindle speed is given",
    .why = "The smaller the diameter, the faster the spindle turns: on the way to the centre it runs up to "
           "the highest speed of the machine, which the chuck or the work may not bear.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"no_clamp",
                  "No highest speed: under the constant surface speed of '{0}' line {1} moves, and nothing "
                  "has clamped the spindle before.",
                  "Write {2} before, with the highest speed of the work."}},
    .bad = {{"fanuc", R"nc(
O9570(FACE)
G21 G40 G97 G99
T0101
G96 S200 M3
G0 X54. Z0. M8
G1 X-1.6 F0.2
G0 X150. Z120.
M30
)nc"},
            {"fanuc", R"nc(
O9570(FACE)
G21 G40 G97 G95 G90
T0101
G92 X150. Z120.
G96 S200 M3
G0 X54. Z0. M8
G1 X-1.6 F0.2
M30
)nc"},
            {"sinumerik", R"nc(
G18 G90 G54 G95 DIAMON
G96 S220 M4 F0.25
G0 X34 Z2
G1 X0
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9570(FACE)
G21 G40 G97 G99
T0101
G96 S200 M3
G50 S2500
G0 X54. Z0. M8
G1 X-1.6 F0.2
G0 X150. Z120.
M30
)nc"},
             {"fanuc", R"nc(
O9571(HIGHEST SPEED OF THE WORK IN A VARIABLE)
G21 G40 G97 G99
T0101
G50 S#101
G96 S200 M3
G0 X54. Z0. M8
G1 X-1.6 F0.2
G0 X150. Z120.
M30
)nc"},
             {"fanuc", R"nc(
O9572(ITS CALLER HAS CLAMPED THE SPINDLE)
G96 S200 M3
G0 X54. Z0. M8
G1 X-1.6 F0.2
G97 S800
M99
)nc"},
             {"sinumerik", R"nc(
G18 G90 G54 G95 DIAMON
G96 S220 LIMS=2500 M4 F0.25
G0 X34 Z2
G1 X0
M30
)nc"}},
    .sources = {"T"},
    .check = MachineCheck{&check},
};

namespace {

void check(const MachineStep& at, Reporter& reporter) {
    using machine::Move;
    constexpr std::size_t x = 0;
    const MachineWords& letters = at.letters();
    const machine::Known& mode = at.after().of(letters.speed_mode);
    if (!(letters.x_is_diameter || letters.diameter_by_code) || !at.analysis.is_main()) return;
    if (!mode.is(letters.surface_speed) || !at.after().speed_clamp.is_callers()) return;
    if (at.step.move == Move::none || at.step.move == Move::elsewhere || at.step.move == Move::unknown)
        return;
    if (!at.step.axes[x] && !at.cuts()) return;
    if (!at.is_first_of(at.after().speed_clamp)) return;
    const Span set = at.at(mode, {}).span;
    const std::string clamp = letters.clamp_address.empty()
                                  ? "G" + number_word(letters.clamping.front()) + " S"
                                  : std::string(letters.clamp_address) + "=";
    const std::string line = line_number(at.analysis.file(), at.block().begin);
    reporter.report({at.analysis, set}, set, "no_clamp", {quoted(at.analysis.program(), set), line, clamp})
        .related.push_back({at.analysis.source(), at.block(), "it moves in X here"});
}

} // namespace
} // namespace maclint::rules
