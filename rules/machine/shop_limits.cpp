//! MAC587: numbers beyond what the shop allows on its machine.
#include "analyzer/program/shop_demands.hpp"
#include "rules/machine_check.hpp"
#include "rules/path.hpp"

#include <array>
#include <cmath>
#include <string>
#include <string_view>

namespace maclint::rules {

namespace {
void check(const MachineStep& at, Reporter& reporter);
}

extern const Rule shop_limits{
    .code = "MAC587",
    .name = "limit-exceeded",
    .summary =
        "A speed, a feed, a tool or a position beyond the limits that the configuration gives the machine",
    .why =
        "The machine turns or feeds no faster than it can, stops at the end of its travel, or takes the tool "
        "from a place that it does not have. Only the shop knows its limits: without them nothing is told.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"above", "Above the limit: {0} of '{1}' is {2}, and the configuration allows {3} at most.",
                  "Correct the number, or the limit '{4}' of the control."},
                 {"below",
                  "Below the limit: {0} of '{1}' is {2}, and the configuration demands {3} at least.",
                  "Correct the number, or the limit '{4}' of the control."}},
    .bad = {Example("fanuc", R"nc(
O9586(PLATE)
G90 G17 G21 G54
T1 M6
S15000 M3
G0 X0 Y0
G43 H1 Z50.
G1 Z-5. F200.
X620.
G0 Z50.
M30
)nc")
                .on_control_with(R"("limits": {"speed": 12000, "X": [-10, 600]})")},
    .good = {Example("fanuc", R"nc(
O9586(PLATE)
G90 G17 G21 G54
T1 M6
S12000 M3
G0 X0 Y0
G43 H1 Z50.
G1 Z-5. F200.
X600.
G0 Z50.
M30
)nc")
                 .on_control_with(R"("limits": {"speed": 12000, "X": [-10, 600]})"),
             {"fanuc", R"nc(
O9586(NOBODY HAS NAMED A LIMIT)
G90 G17 G21 G54
T1 M6
S40000 M3
G43 H1 Z50.
G1 Z-5. F200.
G0 Z50.
M30
)nc"}},
    .sources = {"T"},
    .check = MachineCheck{&check},
};

namespace {

/// One number of a block, as the machine takes it.
struct Commanded {
    std::string what;
    std::string_view key;
    double number;
    Span place;
};

void hold(const MachineStep& at, const Commanded& one, const Bounds& bounds, Reporter& reporter) {
    if (bounds.contain(one.number)) return;
    const bool is_above = one.number > bounds.greatest;
    reporter.report(at.cause(), one.place, is_above ? "above" : "below",
                    {one.what, at.quoted_block(), number_word(one.number),
                     number_word(is_above ? bounds.greatest : bounds.least), std::string(one.key)});
}

/// A surface speed is none of the spindle, and its highest speed is no command to turn.
void check_speed(const MachineStep& at, const Bounds& bounds, Reporter& reporter) {
    const auto speed = at.step.words.number('S');
    const machine::Known& mode = at.after().of(ModalRole::speed_mode);
    if (!speed || speed->value == 0 || at.step.words.has_one_of(at.letters().clamping)) return;
    if (mode.kind == machine::Known::Kind::unknown || mode.is(at.letters().surface_speed)) return;
    hold(at, {"the speed", "speed", speed->value, speed->span}, bounds, reporter);
}

void check_tool(const MachineStep& at, const Bounds& bounds, Reporter& reporter) {
    const auto tool = at.step.words.number(at.letters().tool);
    if (!tool || tool->value == 0) return;
    constexpr double offsets = 100;
    const bool holds_offset = at.letters().tool_word_holds_offset;
    if (holds_offset && tool->value < offsets) return; // T101 and T1 do not say what of them is the offset
    hold(at, {"the tool", "tool", holds_offset ? std::floor(tool->value / offsets) : tool->value, tool->span},
         bounds, reporter);
}

double mm(const MachineStep& at) {
    return at.after().of(ModalRole::units).is(at.letters().inch) ? machine::millimetres_of_inch : 1;
}

/// Nobody has said a mode: a mill then feeds per minute. A lathe may feed either way.
void check_feed(const MachineStep& at, const ShopLimits& limits, Reporter& reporter) {
    const auto feed = at.step.words.number('F');
    const MachineWords& letters = at.letters();
    const machine::Known& mode = at.after().of(ModalRole::feed_mode);
    const bool is_lead = !takes_feed(at.step, letters) || at.step.words.has_one_of(letters.threads) ||
                         at.step.words.has_one_of(letters.tapping_cycles);
    if (!feed || feed->value == 0 || is_lead) return;
    if (mode.is(letters.feed_per_minute) || (mode.is_callers() && !letters.tool_word_holds_offset))
        hold(at, {"the feed per minute", "feed-per-minute", feed->value * mm(at), feed->span},
             limits.feed_per_minute, reporter);
    if (mode.is(letters.feed_per_revolution))
        hold(at, {"the feed per revolution", "feed-per-revolution", feed->value * mm(at), feed->span},
             limits.feed_per_revolution, reporter);
}

/// The first block of a program in which an axis goes beyond.
void check_travel(const MachineStep& at, const ShopLimits& limits, Reporter& reporter) {
    using machine::Move;
    const Move move = at.step.move;
    if (move != Move::rapid && move != Move::feed && move != Move::cycle) return;
    if (machine::counts_from_elsewhere(at.after(), at.analysis.control())) return;
    constexpr std::array<std::string_view, 3> axes = {"X", "Y", "Z"};
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
        if (!at.step.axes[axis]) continue;
        double position = at.after().position[axis];
        const bool is_depth = move == Move::cycle && axis == 2;
        if (is_depth && at.after().of(ModalRole::distance).is(at.letters().absolute))
            if (const auto depth = at.step.words.number(at.letters().axes[axis]); depth && depth->is_length())
                position = depth->value;
        if (std::isnan(position) || limits.travel[axis].contain(position * mm(at))) continue;
        if (!at.told.insert(static_cast<Offset>(axis)).second) continue;
        hold(at,
             {"the position along " + std::string(axes[axis]), axes[axis], position * mm(at),
              at.place_of(at.letters().axes[axis])},
             limits.travel[axis], reporter);
    }
}

void check(const MachineStep& at, Reporter& reporter) {
    if (at.analysis.control().demands == nullptr) return;
    const ShopLimits& limits = at.analysis.control().demands->limits;
    check_speed(at, limits.speed, reporter);
    check_tool(at, limits.tool, reporter);
    check_feed(at, limits, reporter);
    check_travel(at, limits, reporter);
}

} // namespace
} // namespace maclint::rules
