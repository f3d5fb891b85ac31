//! Holds feeds against limits in each unit.
#include "rules/machine/feed_size.hpp"

#include <algorithm>
#include <cmath>

namespace maclint {
namespace {

/// A lathe that works at such a diameter or length, given as a number, does not count in inches.
bool is_at_metric_place(const machine::State& state, const MachineWords& letters) {
    constexpr double longest_in_inches = 20;
    return letters.x_is_diameter && std::ranges::any_of(state.position, [](double place) {
               return std::abs(place) > longest_in_inches;
           });
}

} // namespace

FeedSize::FeedSize(const machine::State& state, const MachineWords& letters) {
    const machine::Known& unit = state.of(ModalRole::units);
    may_be_metric_ = !unit.is(letters.inch);
    may_be_inch_ = !unit.is(letters.metric) && (!may_be_metric_ || !is_at_metric_place(state, letters));
}

bool FeedSize::is_too_much_for_a_turn(double feed) const {
    constexpr double most_in_mm = 10, most_in_inches = 0.4;
    return feed >= (may_be_metric_ ? most_in_mm : most_in_inches);
}

bool FeedSize::is_too_little_for_a_minute(double feed) const {
    constexpr double least_in_mm = 1, least_in_inches = 0.03;
    return feed > 0 && feed < (may_be_inch_ ? least_in_inches : least_in_mm);
}

} // namespace maclint
