//! MAC525: a thread, or a hole on the centre, under constant surface speed.
#include "rules/machine_check.hpp"
#include "rules/path.hpp"

#include <algorithm>
#include <cmath>

namespace maclint::rules {

namespace {
void check(const MachineStep& at, Reporter& reporter);
}

extern const Rule thread_under_surface_speed{
    .code = "MAC525",
    .name = "thread-under-surface-speed",
    .summary = "A thread is cut, or the centre drilled, under constant surface speed",
    .why = "The speed follows the diameter. The passes of a thread begin at other angles, and do not meet "
           "where the lead changes with them; on the centre the spindle runs at its highest speed, whatever "
           "S says.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"thread",
                  "Thread under {1}: '{0}' cuts with the constant surface speed of line {2}, so that the "
                  "speed changes from pass to pass.",
                  "Write {3} S before, with the speed in revolutions."},
                 {"centre",
                  "Hole on the centre under {1}: at X{0} the constant surface speed of line {2} turns the "
                  "spindle as fast as it may.",
                  "Write {3} S before, with the speed in revolutions."}},
    .bad = {{"fanuc", R"nc(
O9525(THREAD)
G21 G40 G99
G50 S2000
T0303
G96 S60 M3
G0 X32. Z6. M8
G92 X29.2 Z-32. F3.
M30
)nc"},
            {"fanuc", R"nc(
O9525(DRILL)
G21 G40 G99
G50 S2000
T0505
G96 S80 M3
G0 X0. Z5. M8
G74 R1.
G74 Z-48. Q8000 F0.14
M30
)nc"},
            {"fanuc", R"nc(
O9525(THREAD)
G71 G40 G90 G95
G92 S2000
T0303
G96 S60 M3
G0 X32. Z6. M8
G21 X29.2 Z-32. F3.
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9525(THREAD AND DRILL)
G21 G40 G99
G50 S2000
T0303
G97 S600 M3
G0 X32. Z6. M8
G92 X29.2 Z-32. F3.
G0 X150. Z80.
T0505
G0 X0. Z5.
G74 Z-48. Q8000 F0.14
M30
)nc"}},
    .sources = {"T"},
    .check = MachineCheck{&check},
};

namespace {

bool contains(std::span<const double> codes, const machine::Known& code) {
    return code.is_known() && std::ranges::find(codes, code.value) != codes.end();
}

bool cuts_thread(const MachineStep& at) {
    return at.step.words.has_one_of(at.letters().threads) ||
           (at.cuts() && contains(at.letters().threads, at.after().of(ModalRole::motion)));
}

/// Where the block drills; nothing where it does not, or nobody can say.
std::optional<double> x_of_hole(const MachineStep& at) {
    constexpr std::size_t x = 0;
    const MachineWords& letters = at.letters();
    const bool in_cycle =
        at.step.words.has_one_of(letters.holes) || contains(letters.holes, at.after().of(ModalRole::cycle));
    if (at.step.move != machine::Move::cycle || !in_cycle) return std::nullopt;
    if (!at.step.axes[x]) {
        const double place = at.before().position[x];
        return std::isnan(place) ? std::nullopt : std::optional(place);
    }
    if (at.step.words.has_one_of(letters.holes_without_x)) return std::nullopt; // a groove
    const bool counts_from_here = at.analysis.control().group_with(ModalRole::distance) &&
                                  !at.after().of(ModalRole::distance).is(letters.absolute);
    if (counts_from_here) return std::nullopt;
    const auto place = at.step.words.number(letters.axes[x]);
    return place && place->is_length() ? std::optional(place->value) : std::nullopt;
}

void check(const MachineStep& at, Reporter& reporter) {
    const machine::Known& mode = at.after().of(ModalRole::speed_mode);
    if (!at.letters().x_is_diameter || !mode.is(at.letters().surface_speed) || mode.by_call) return;
    const std::string surface = at.spelled(at.after(), ModalRole::speed_mode);
    const auto group = *at.analysis.control().group_with(ModalRole::speed_mode);
    const std::string turns = at.analysis.control().spell(group, at.letters().surface_speed + 1);
    const auto report = [&](std::string_view id, std::string what) {
        if (!at.is_first_of(mode)) return;
        reporter.report(at.cause(), at.block(), id, {std::move(what), surface, at.line_of(mode), turns})
            .related.push_back(at.at(mode, "constant surface speed begins here"));
    };
    if (cuts_thread(at)) return report("thread", at.quoted_block());
    constexpr double near_in_mm = 0.1, near_in_inches = 0.004;
    const bool is_metric = at.after().of(ModalRole::units).is(at.letters().metric);
    const auto x = x_of_hole(at);
    if (x && std::abs(*x) < (is_metric ? near_in_mm : near_in_inches)) report("centre", number_word(*x));
}

} // namespace
} // namespace maclint::rules
