//! How states meet.
#include "analyzer/machine/state.hpp"

#include <algorithm>
#include <cmath>

namespace maclint::machine {

template<class Visit>
void State::for_each_two(State& a, const State& b, const Visit& visit) {
    constexpr std::array fields = {&State::tool,
                                   &State::prepared,
                                   &State::changed,
                                   &State::length_offset,
                                   &State::cutter_offset,
                                   &State::speed_clamp,
                                   &State::cycle_level,
                                   &State::moved_in_z,
                                   &State::plunged,
                                   &State::cut,
                                   &State::distance_for_return,
                                   &State::rigid_tapping,
                                   &State::profile_end,
                                   &State::coolant};
    for (const auto field : fields) visit(a.*field, b.*field);
    for (std::size_t role = 0; role < roles; ++role) visit(a.modes_[role], b.modes_[role]);
}

void State::forget_modes() { modes_.fill(Known::nothing()); }

void State::forget_position() {
    position.fill(nowhere);
    cycle_start.fill(nowhere);
    is_moved.fill(true);
}

void State::forget() {
    tool = prepared = changed = length_offset = cutter_offset = speed_clamp = cycle_level = moved_in_z =
        plunged = cut = distance_for_return = rigid_tapping = profile_end = coolant = Known::nothing();
    demands_met = ~std::uint64_t{0};
    without_offset_since = offset_chosen_at = no_block;
    forget_modes();
    forget_position();
}

bool State::add_missing_offset(const State& other) {
    const auto chosen = [](const State& one) {
        return one.length_offset.is_known() && one.length_offset.value > 0 ? one.length_offset.block
                                                                           : no_block;
    };
    const Offset since = std::min(without_offset_since, other.without_offset_since);
    Offset at = std::min(offset_chosen_at, other.offset_chosen_at);
    if (without_offset_since != no_block) at = std::min(at, chosen(other));
    if (other.without_offset_since != no_block) at = std::min(at, chosen(*this));
    const bool has_changed = since != without_offset_since || at != offset_chosen_at;
    without_offset_since = since;
    offset_chosen_at = at;
    return has_changed;
}

bool State::add(const State& other) {
    if (!other.is_reached) return false;
    if (!is_reached) {
        *this = other;
        return true;
    }
    bool has_changed = add_missing_offset(other);
    for_each_two(*this, other, [&](Known& mine, const Known& its) {
        if (mine.kind == Known::Kind::unknown) return;
        if (mine.kind == its.kind && (mine.is_callers() || mine.value == its.value)) return;
        mine = Known::nothing();
        has_changed = true;
    });
    if ((other.demands_met & ~demands_met) != 0) {
        demands_met |= other.demands_met;
        has_changed = true;
    }
    for (std::size_t axis = 0; axis < position.size(); ++axis) {
        if (!std::isnan(position[axis]) && position[axis] != other.position[axis]) {
            position[axis] = nowhere;
            has_changed = true;
        }
        if (!std::isnan(cycle_start[axis]) && cycle_start[axis] != other.cycle_start[axis]) {
            cycle_start[axis] = nowhere;
            has_changed = true;
        }
        if (other.is_moved[axis] && !is_moved[axis]) is_moved[axis] = has_changed = true;
    }
    return has_changed;
}

void State::go_on_with(const State& end_of_called, Offset block) {
    for_each_two(*this, end_of_called, [block](Known& mine, const Known& its) {
        if (its.is_callers()) return;
        mine = its;
        mine.block = block;
        mine.by_call = true;
    });
    demands_met |= end_of_called.demands_met;
    if (!end_of_called.length_offset.is_callers()) without_offset_since = offset_chosen_at = no_block;
    for (std::size_t axis = 0; axis < position.size(); ++axis) {
        if (!end_of_called.is_moved[axis]) continue;
        position[axis] = end_of_called.position[axis];
        is_moved[axis] = true;
    }
}

} // namespace maclint::machine
