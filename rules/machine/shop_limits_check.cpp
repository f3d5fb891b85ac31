//! Of MAC587: holds the numbers of a block against what the shop allows.
#include "rules/machine/shop_limits_check.hpp"

#include "rules/path.hpp"

#include <array>
#include <cmath>
#include <string>
#include <string_view>

namespace maclint::rules {
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

} // namespace

void look_for_broken_limits(const MachineStep& at, const ShopLimits& limits, Reporter& reporter) {
    check_speed(at, limits.speed, reporter);
    check_tool(at, limits.tool, reporter);
    check_feed(at, limits, reporter);
    check_travel(at, limits, reporter);
}

} // namespace maclint::rules
