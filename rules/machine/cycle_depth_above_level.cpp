//! MAC532: a canned cycle whose bottom lies above the level from which it feeds.
#include "analyzer/dataflow/facts/call_begun.hpp"
#include "analyzer/dataflow/facts/point_state.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "rules/machine_check.hpp"
#include "rules/path.hpp"

namespace maclint::rules {

namespace {
void check(const MachineStep& at, Reporter& reporter);
}

extern const Rule cycle_depth_above_level{
    .code = "MAC532",
    .name = "cycle-depth-above-level",
    .summary = "The bottom of a canned cycle lies above the level from which it feeds",
    .why =
        "The minus sign is missing, or R and Z are exchanged: the tool drills into the air, or comes down at "
        "rapid to where it should begin to cut.",
    .severity = Severity::warning,
    .precision = Precision::very_high,
    .facts = dataflow::facts<dataflow::BeforeNode, dataflow::CallBegun, dataflow::Read>(),
    .messages = {{"above",
                  "Bottom of the cycle above its start: '{0}' is no deeper than '{1}', from where the tool "
                  "feeds down.",
                  "Correct the sign, or the two values."},
                 {"up", "Bottom of the cycle above its start: under G91 '{0}' counts from {1} upwards.",
                  "Write it with a minus."}},
    .bad = {{"fanuc", R"nc(
O9532(HOLES)
G21 G17 G90 G54 G0 X10. Y10.
G43 H1 Z50. S2000 M3
G98 G81 X10. Y10. Z18. R2. F150.
G80
M30
)nc"},
            {"fanuc", R"nc(
O9532(HOLES)
G21 G17 G90 G54 G0 X10. Y10.
G43 H1 Z50. S2000 M3
G91 G98 G81 X10. Z18. R-48. F150.
G80
G90
M30
)nc"},
            {"fanuc", R"nc(
O0001(MAIN)
G65 P9533 Z18. R2. F150.
M30
O9533(HOLE, Z DEPTH, R LEVEL)
G17 G90 G98 G81 Z#26 R#18 F#9
G80
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9532(HOLES)
G21 G17 G90 G54 G0 X10. Y10.
G43 H1 Z50. S2000 M3
G98 G81 X10. Y10. Z-18. R2. F150.
G87 X30. Z5. R-20. Q1. F100.
G80
M30
)nc"}},
    .sources = {"T"},
    .check = MachineCheck{.check = &check, .with_numbers_of_calls = true},
};

namespace {

/// Boring from below: its level lies under the work.
constexpr double back_boring = 87;

/// A number without a point may mean steps of a thousandth.
std::optional<double> length(const std::optional<machine::Number>& number) {
    if (!number || (!number->decimal_point && number->value != 0)) return std::nullopt;
    return number->value;
}

void check(const MachineStep& at, Reporter& reporter) {
    constexpr std::size_t z = 2;
    const MachineWords& letters = at.letters();
    if (at.step.move != machine::Move::cycle || letters.x_is_diameter) return;
    const machine::Known& cycle = at.after().of(ModalRole::cycle);
    const machine::Known& plane = at.after().of(ModalRole::plane);
    const auto planes = at.analysis.control().group_with(ModalRole::plane);
    if (!at.is_on(at.after(), ModalRole::cycle) || cycle.is(back_boring) || !planes) return;
    const double flat = at.analysis.control().groups[*planes].members.front().number;
    if (!plane.is_callers() && !plane.is(flat)) return;
    const auto bottom = length(at.step.words.number(letters.axes[z]));
    const auto level = length(at.step.words.number(letters.radius));
    const machine::Known& distance = at.after().of(ModalRole::distance);
    if (!bottom || !level || !distance.is_known()) return;
    const Span place = at.place_of(letters.axes[z]);
    const std::vector<std::string> words = {quoted(at.analysis.program(), place),
                                            quoted(at.analysis.program(), at.place_of(letters.radius))};
    if (distance.is(letters.absolute)) {
        if (*bottom >= *level) reporter.report({at.analysis, place}, place, "above", words);
    } else if (*bottom > 0) {
        reporter.report({at.analysis, place}, place, "up", words);
    }
}

} // namespace
} // namespace maclint::rules
