//! MAC534: a turret that turns while its tool stands at the work.
#include "rules/machine_check.hpp"
#include "rules/path.hpp"

#include <algorithm>
#include <cmath>

namespace maclint::rules {

namespace {
void check(const MachineStep& at, Reporter& reporter);
}

extern const Rule turret_turned_at_work{
    .code = "MAC534",
    .name = "turret-turned-at-work",
    .summary = "A turret turns to another tool where the last one has cut, though the program retreats with "
               "others",
    .why = "The tools beside it come round at the same height: they hit the work or the chuck.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"at_work",
                  "Turret turned at the work: '{0}' brings another tool while {1} stands at X{2} Z{3}, where "
                  "it has cut.",
                  "Retreat before, as the program does with its other tools."}},
    .bad = {{"fanuc", R"nc(
O9534(SHAFT)
G28 U0 W0
G21 G40 G97 G99
T0101
G0 X52. Z2. M8
G1 Z-30. F0.2
G0 X150. Z120.
T0202
G0 X48. Z-3.
G1 Z-30. F0.1
X52.
T0404
G0 X54. Z-22. M8
G1 X40. F0.08
G0 X150. Z120.
M30
)nc"},
            {"fanuc", R"nc(
O9534(SHAFT, OFFSETS TAKEN BACK)
G21 G40 G97 G99
T0101
G0 X52. Z0.5 M8
G71 U2. R0.5
G71 P10 Q20 U0.4 W0.1 F0.25
N10 G0 X20.
G1 Z-40.
N20 X52.
M9
T0100
T0202
G0 X52. Z2. M8
G70 P10 Q20
G0 X150. Z120.
T0200
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9534(SHAFT)
G21 G40 G97 G99
T0101
G0 X52. Z2. M8
G1 Z-30. F0.2
G0 X150. Z120.
T0202
G0 X48. Z2. M8
G1 Z-30. F0.1
X52.
G28 U0 W0
T0404
G0 X54. Z-22. M8
G1 X40. F0.08
G0 X150.
T0606
G0 X50. Z2.
G1 Z-3. F0.1
G0 X150. Z120.
M30
)nc"}},
    .sources = {"T"},
    .check = MachineCheck{&check},
};

namespace {

/// A number beyond any lathe that counts in inches tells the unit, too.
bool is_metric(const MachineStep& at) {
    constexpr double longest_in_inches = 20;
    const machine::Known& unit = at.before().of(ModalRole::units);
    if (unit.is_known()) return unit.is(at.letters().metric);
    return std::ranges::any_of(at.before().position,
                               [](double place) { return std::abs(place) > longest_in_inches; });
}

void check(const MachineStep& at, Reporter& reporter) {
    constexpr std::size_t x = 0, z = 2;
    if (!at.letters().tool_word_holds_offset || !at.step.changes_tool || at.habits.retreats() == 0) return;
    const machine::Known& tool = at.before().tool;
    if (!tool.is_known() || !at.after().tool.is_known() || at.after().tool.is(tool.value)) return;
    const auto widest = at.habits.widest_cut();
    const machine::Position& place = at.before().position;
    if (!at.before().cut.is(1) || !widest || std::isnan(place[x]) || std::isnan(place[z])) return;
    const double unit = is_metric(at) ? 1 : 1 / machine::millimetres_of_inch;
    const double height = at.habits.retreats() > 1 ? 10 : 1, beside = 30; // mm
    if (place[z] >= height * unit || place[x] >= *widest + beside * unit) return;
    const Span word = at.place_of(at.letters().tool);
    reporter
        .report({at.analysis, word}, word, "at_work",
                {quoted(at.analysis.program(), word), at.letters().tool + number_word(tool.value),
                 number_word(place[x]), number_word(place[z])})
        .related.push_back(at.at(at.before().cut, "it has cut here"));
}

} // namespace
} // namespace maclint::rules
