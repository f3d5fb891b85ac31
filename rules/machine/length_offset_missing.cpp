//! MAC568: a tool that goes to its work without its length offset.
#include "rules/machine/offset_skipped.hpp"
#include "rules/machine/offset_taken_back.hpp"
#include "rules/path.hpp"

namespace maclint::rules {

namespace {
void check(const MachineStep& at, Reporter& reporter);
}

extern const Rule length_offset_missing{
    .code = "MAC568",
    .name = "length-offset-missing",
    .summary = "A tool goes to its work without a length offset, which the program gives its other tools",
    .why = "The control counts with the length of the tool before, or with none: the tool stops above the "
           "work, or runs into it.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages =
        {{"none",
          "No tool length offset: '{0}' moves in Z with the tool of {1}, for which no offset has been "
          "chosen.",
          "Choose it with G43 H before, or in this block."},
         {"path",
          "No tool length offset on one path: '{0}' moves in Z with the tool of {1}, past '{2}' of line {3}.",
          "Choose it where all paths come by."},
         {"taken_back",
          "No tool offset: '{0}' cuts with tool {1}, of which line {2} has taken the offset back.",
          "Write the tool with its offset before it cuts."}},
    .bad = {{"fanuc", R"nc(
O9568(PLATE)
G90 G17 G54
T1 M6
S3000 M3
G0 X0 Y0
G43 H1 Z50.
G1 Z-5. F200.
G0 Z50.
T2 M6
S1200 M3
G0 X25. Y25.
Z50.
G1 Z-12. F100.
G0 Z50.
M30
)nc"},
            {"fanuc", R"nc(
O9568(SHAFT)
G28 U0 W0
G21 G40 G97 G99
T0101
G97 S1200 M3
G0 X52. Z2. M8
G1 Z-30. F0.2
G0 X150. Z120. T0100
G0 X48. Z2. (T0202 IS LOST)
G1 Z-30. F0.1
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9568(PLATE)
G90 G17 G54
T1 M6
S3000 M3
G0 X0 Y0
G43 H1 Z50.
G1 Z-5. F200.
G0 Z50.
T2 M6
S1200 M3
G0 X25. Y25.
G43 H2 Z50.
G1 Z-12. F100.
G0 Z50.
M30
)nc"},
             {"fanuc", R"nc(
O9569(PROBE HEIGHT BY HAND)
G90 G17 G54
T1 M6
S3000 M3
G0 Z50.
G1 Z-5. F200.
M30
)nc"},
             {"fanuc", R"nc(
O9568(TURNED FIRST, OFFSET WITH THE APPROACH, TAKEN BACK IN THE RETREAT)
G28 U0 W0
G21 G40 G97 G99
T0100
G97 S1200 M3
G0 X52. Z2. T0101 M8
G1 Z-30. F0.2
G0 X150. Z120. T0100
T0300
G0 X54. Z-22. T0303 M8
G1 X40. F0.08
M30
)nc"}},
    .sources = {"T"},
    .check = MachineCheck{&check},
};

namespace {

void check(const MachineStep& at, Reporter& reporter) {
    using machine::Move;
    if (at.letters().tool_word_holds_offset) return look_for_offset_taken_back(at, reporter);
    constexpr std::size_t z = 2;
    if (!at.step.axes[z] || at.step.changes_tool || at.letters().length_offset == 0) return;
    if (at.step.move == Move::elsewhere || at.step.move == Move::unknown || at.step.move == Move::none)
        return;
    look_for_offset_skipped(at, reporter);
    if (!at.after().length_offset.is(machine::not_since_change) || !at.after().changed.is_known()) return;
    if (!at.before().moved_in_z.is(0) || at.habits.tools_with_length_offset() == 0) return;
    if (at.is_on(at.after(), ModalRole::length_compensation) &&
        at.after().of(ModalRole::length_compensation).block == at.block().begin)
        return; // G43 without H is another matter
    reporter
        .report(at.cause(), at.place_of('Z'), "none",
                {at.quoted_block(), "line " + at.line_of(at.after().changed)})
        .related.push_back(at.at(at.after().changed, "the tool is changed here"));
}

} // namespace
} // namespace maclint::rules
