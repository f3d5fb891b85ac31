//! Keeps the last moves that may still turn out to be such a pair.
#include "analyzer/machine/lift_watch.hpp"

#include <algorithm>
#include <cmath>

namespace maclint::machine {
namespace {

constexpr std::size_t z_axis = 2;
constexpr std::size_t most_places = 200; ///< of one depth; a path with more is no programmer's

SideMove move_of(const Step& step) {
    const Known& compensation = step.after.of(ModalRole::cutter_compensation);
    return {step.block.span,
            step.move == Move::rapid,
            step.move == Move::feed,
            step.to_reference,
            step.axes[0] || step.axes[1],
            step.axes[z_axis],
            step.before.position[z_axis],
            step.after.position[z_axis],
            {step.axes[0], step.axes[1]},
            compensation.is_known() && compensation.block == step.block.span.begin,
            {step.after.position[0], step.after.position[1]}};
}

bool is_lift(const SideMove& move) { return move.in_z && !move.aside; }

bool returns_behind(const SideMove& aside, const SideMove& lift) {
    return is_lift(lift) && aside.to_reference && lift.to_reference;
}

bool goes_up_behind(const SideMove& aside, const SideMove& lift) {
    return is_lift(lift) && aside.rapid && lift.rapid && lift.z_after >= 0;
}

bool goes_down_from(double z, const SideMove& next) {
    return is_lift(next) && !next.to_reference && next.z_after < z;
}

} // namespace

void LiftWatch::see(const Step& step) {
    if (step.changes_tool) {
        is_down_ = after_call_ = false;
        aside_.reset();
        lifted_.reset();
    } else if (step.move != Move::none) {
        if (after_call_) is_down_ = step.before.plunged.is(1);
        after_call_ = false;
        add(move_of(step));
    }
    if (!step.calls) return;
    if (aside_) before_calls_.push_back({*aside_, step.block.span});
    aside_.reset();
    lifted_.reset();
    after_call_ = true;
}

void LiftWatch::add(const SideMove& move) {
    constexpr std::size_t wanted = 2;
    if (first_.size() < wanted) first_.push_back(move);
    if (lifted_ && goes_down_from(lifted_->z, move)) lifts_.push_back(lifted_->late);
    lifted_.reset();
    if (aside_) {
        const LateLift late{aside_->block, aside_->z_before, move.block};
        if (returns_behind(*aside_, move) || (goes_up_behind(*aside_, move) && leads_elsewhere(*aside_)))
            lifts_.push_back(late);
        else if (goes_up_behind(*aside_, move))
            lifted_ = Lifted{late, move.z_after};
    }
    aside_.reset();
    if (is_down_ && move.z_before < 0 && move.aside && !move.in_z && (move.rapid || move.to_reference))
        aside_ = move;
    compensates_ = (compensates_ && !move.in_z) || move.sets_compensation;
    if (move.in_z) {
        is_down_ = move.feed && move.z_after < move.z_before;
        has_cut_ = false;
        places_.clear();
    } else if (!aside_) {
        has_cut_ |= is_down_ && move.feed && move.aside;
    }
    if (is_down_ && !aside_ && places_.size() < most_places) places_.push_back(move.x_y_after);
}

bool LiftWatch::leads_elsewhere(const SideMove& aside) const {
    const auto is_known = [](const std::array<double, 2>& place) {
        return !std::isnan(place[0]) && !std::isnan(place[1]);
    };
    return has_cut_ && !compensates_ && !aside.sets_compensation && places_.size() < most_places &&
           aside.axes[0] && aside.axes[1] && is_known(aside.x_y_after) &&
           std::ranges::all_of(
               places_, [&](const auto& place) { return is_known(place) && place != aside.x_y_after; });
}

bool LiftWatch::begins_with_lift_of(const SideMove& aside) const {
    if (first_.empty()) return false;
    if (returns_behind(aside, first_.front())) return true;
    return first_.size() > 1 && goes_up_behind(aside, first_[0]) &&
           goes_down_from(first_[0].z_after, first_[1]);
}

} // namespace maclint::machine
