//! MAC521: cutter compensation without an offset, or over a change of the tool.
#include "rules/machine/change_under_compensation.hpp"
#include "rules/machine_check.hpp"
#include "rules/path.hpp"

namespace maclint::rules {

namespace {
void check(const MachineStep& at, Reporter& reporter);
}

extern const Rule compensation_without_offset{
    .code = "MAC521",
    .name = "compensation-without-offset",
    .summary = "Cutter compensation has no offset of its tool, or is in force when the tool is changed",
    .why = "The control works with the radius of another tool, or with none: the contour is wrong by the "
           "difference. "
           "A tool change under compensation stops some controls, and on others the next tool moves beside "
           "its path.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages =
        {{"none", "Compensation without an offset: '{0}', and no D stands before it.",
          "Write D with the number of the tool's offset."},
         {"zero", "Compensation without an offset: '{0}' works with D0, which is no radius.",
          "Write D with the number of the tool's offset."},
         {"other",
          "Compensation with the offset of the tool before: '{0}', and no D stands since the tool change of "
          "line {1}.",
          "Write D with the number of this tool's offset."},
         {"change", "Tool change under compensation: {1} of line {2} is still in force at '{0}'.",
          "Write {3} in a straight move before it."}},
    .bad = {{"fanuc", R"nc(
O9521(PLATE)
G90 G17 G54 G40
T1 M6
S3000 M3
G43 H1 Z-5.
G1 G41 X0 F200.
G40 X-20.
M30
)nc"},
            {"fanuc", R"nc(
O9521(PLATE)
G90 G17 G54 G40
T1 M6
S3000 M3
G43 H1 Z-5.
G1 G41 D0 X0 F200.
Y40.
G40 X-20.
M30
)nc"},
            {"fanuc", R"nc(
O9521(PLATE)
G90 G17 G54 G40
T1 M6
S3000 M3
G43 H1 Z-5.
G1 G41 D1 X0 F200.
Y40.
G40 X-20.
G0 Z50.
T2 M6
S3000 M3
G43 H2 Z-5.
G1 G41 X0 F200.
Y40.
G40 X-20.
M30
)nc"},
            {"fanuc", R"nc(
O9521(PLATE)
G90 G17 G54 G40
T1 M6
S3000 M3
G43 H1 Z-5.
G1 G41 D1 X0 F200.
Y40.
G0 Z50.
T2 M6
S3000 M3
G40 M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9521(PLATE)
G90 G17 G54 G40
T1 M6
S3000 M3
G0 X-20. Y0 D1
G43 H1 Z-5.
G1 G41 X0 F200.
Y40.
G40 X-20.
M30
)nc"}},
    .sources = {"T"},
    .check = MachineCheck{&check},
};

namespace {

void check(const MachineStep& at, Reporter& reporter) {
    // T0100 behind T0101 takes an offset back, and turns nothing.
    const bool keeps_tool = at.letters().tool_word_holds_offset &&
                            (!at.before().tool.is_known() || at.after().tool.is(at.before().tool.value));
    if (at.step.changes_tool && !keeps_tool) return check_change_under_compensation(at, reporter);
    const char letter = at.letters().cutter_offset;
    const machine::Known& on = at.after().of(ModalRole::cutter_compensation);
    if (letter == 0 || !at.is_on(at.after(), ModalRole::cutter_compensation) || on.block != at.block().begin)
        return;
    // Other controls have the radius itself there, or the number of the offset in another word.
    if (at.step.words.has('P') || at.step.words.has('H') || at.step.words.has('R')) return;
    const machine::Known& offset = at.after().cutter_offset;
    // Who numbers no offset of the length may have the radius elsewhere, too.
    const bool none =
        offset.is_callers() && at.analysis.is_main() && at.habits.tools_with_length_offset() > 0;
    const bool is_others = offset.is(machine::not_since_change);
    if ((!none && !is_others && !offset.is(0)) || !at.is_first_of(offset)) return;
    reporter.report(at.cause(), at.block(),
                    none        ? "none"
                    : is_others ? "other"
                                : "zero",
                    {at.quoted_block(), at.line_of(offset)});
}

} // namespace
} // namespace maclint::rules
