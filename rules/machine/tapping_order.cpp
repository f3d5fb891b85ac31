//! MAC530: what stands between rigid tapping and its cycle.
#include "rules/machine_check.hpp"
#include "rules/path.hpp"

#include <string>

namespace maclint::rules {

namespace {
void check(const MachineStep& at, Reporter& reporter);
}

extern const Rule tapping_order{
    .code = "MAC530",
    .name = "tapping-order",
    .summary = "A move, a speed or a plane stands between M29 and the tapping cycle",
    .why = "M29 prepares the spindle for the very next block, the cycle. The control stops.",
    .severity = Severity::error,
    .precision = Precision::high,
    .messages = {{"between",
                  "Rigid tapping is interrupted: '{0}' of line {1} stands between {2} and its cycle.",
                  "Write it before {2}."}},
    .bad = {{"fanuc", R"nc(
O9530(TAP)
G90 G17 G54
T1 M6
S500 M3
G0 X0 Y0
G43 H1 Z50.
M29 S500
X10. Y10.
G84 Z-10. R5. F500.
G80
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9530(TAP)
G90 G17 G54
T1 M6
G0 X10. Y10.
G43 H1 Z50.
M29 S500
G84 Z-10. R5. F500.
G80
M29 (CHIP CONVEYOR OFF)
G0 X0 Y0
M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "203", "PROGRAM MISS AT RIGID TAPPING", false},
               {"FANUC 16i/18i/21i", "204", "ILLEGAL AXIS OPERATION", false},
               {"FANUC 30i/0i-D", "203", "PROGRAM MISS AT RIGID TAPPING", false},
               {"FANUC 30i/0i-D", "204", "ILLEGAL AXIS OPERATION", false}},
    .sources = {"T"},
    .check = MachineCheck{&check},
};

namespace {

void check(const MachineStep& at, Reporter& reporter) {
    const machine::Known& between = at.before().rigid_tapping;
    if (!between.is(2) || !at.step.words.has_one_of(at.letters().tapping_cycles) || !at.is_first_of(between))
        return;
    const RelatedLocation place = at.at(between, "it stands here");
    reporter
        .report(
            at.cause(), at.block(), "between",
            {quoted(at.analysis.program(), place.span), at.line_of(between),
             std::string(at.analysis.control().functions.address) + number_word(at.letters().rigid_tapping)})
        .related.push_back(place);
}

} // namespace
} // namespace maclint::rules
