//! MAC509: modes that one another's codes stand in, and are ended in the order in which they began.
#include "rules/machine_check.hpp"
#include "rules/path.hpp"

namespace maclint::rules {

namespace {
void check(const MachineStep& at, Reporter& reporter);
}

extern const Rule cancel_order{
    .code = "MAC509",
    .name = "transform-cancel-order",
    .summary =
        "A rotation ends before the length offset that was chosen under it, or a shift before the rotation "
        "in it",
    .why = "The control wants the last to end first: G68, G43, then G49, G69. Some stop where it is "
           "otherwise; a "
           "move between the two runs in the rotation alone, to a place that nobody has meant.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages =
        {{"rotation_first",
          "Wrong order: '{0}' ends the rotation of line {1} while the length offset of line {2}, which "
          "was chosen under it, is still on.",
          "Write {3} before it."},
         {"move_between",
          "Wrong order: '{0}' moves between the end of the shift, line {1}, and that of the rotation "
          "which began in it, line {2}.",
          "End the rotation first, then the shift, and move behind both."}},
    .bad = {{"fanuc", R"nc(
O9509(SLOT)
G90 G17 G54
T1 M6
S3000 M3
G0 X0 Y0
G68 X0 Y0 R15.
G43 H1 Z20.
G1 Z-2. F100.
X30.
G0 Z20.
G69
G49 Z200.
M30
)nc"},
            {"fanuc", R"nc(
O9509(SLOT)
G90 G17 G54
T1 M6
S3000 M3
G43 H1 Z20.
G52 X40. Y10.
G68 X0 Y0 R15.
G0 X0 Y0
G1 Z-2. F100.
X30.
G0 Z20.
G52 X0 Y0
G0 X0 Y0
G69
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9509(SLOT)
G90 G17 G54
T1 M6
S3000 M3
G43 H1 Z20.
G52 X40. Y10.
G68 X0 Y0 R15.
G0 X0 Y0
G1 Z-2. F100.
X30.
G0 Z20.
G69
G52 X0 Y0
G0 X0 Y0
G49 Z200.
M30
)nc"}},
    .alarms = {{"FANUC 30i/0i-D", "049", "ILLEGAL COMMAND(G68,G69)", false, "rotation_first"}},
    .sources = {"ERRLIB-49", "SEED-002:526-528"},
    .check = MachineCheck{&check},
};

namespace {

/// Whether the program has switched both on, the second under the first.
bool is_under(const MachineStep& at, const machine::State& state, ModalRole inner, ModalRole outer) {
    const machine::Known &in = state.of(inner), &out = state.of(outer);
    return at.is_on(state, inner) && at.is_on(state, outer) && !in.by_call && !out.by_call &&
           in.block > out.block;
}

void check(const MachineStep& at, Reporter& reporter) {
    constexpr ModalRole rotation = ModalRole::rotation, length = ModalRole::length_compensation,
                        shift = ModalRole::local_offset;
    if (!at.before().of(rotation).is_known()) return;
    const auto off = [&](ModalRole role) {
        const auto code = at.off(role);
        return code && at.after().of(role).is(*code);
    };
    const bool ends_rotation = at.is_on(at.before(), rotation) && off(rotation);
    if (ends_rotation && is_under(at, at.before(), length, rotation) && at.is_on(at.after(), length) &&
        at.habits.last_end_of_length_offset() > at.block().begin) {
        const auto group = *at.analysis.control().group_with(length);
        reporter.report(at.cause(), at.block(), "rotation_first",
                        {at.quoted_block(), at.line_of(at.before().of(rotation)),
                         at.line_of(at.before().of(length)),
                         at.analysis.control().spell(group, *at.off(length))});
    }
    const bool ends_shift = is_under(at, at.before(), rotation, shift) && off(shift);
    if (ends_shift && at.is_on(at.after(), rotation)) at.told.insert(at.block().begin);
    const machine::Known& end = at.after().of(shift);
    const bool moves =
        (at.step.move == machine::Move::rapid || at.cuts()) && (at.step.axes[0] || at.step.axes[1]);
    if (!moves || !off(shift) || !at.is_on(at.after(), rotation) || at.told.erase(end.block) == 0) return;
    reporter.report(at.cause(), at.block(), "move_between",
                    {at.quoted_block(), at.line_of(end), at.line_of(at.after().of(rotation))});
}

} // namespace
} // namespace maclint::rules
