//! Writes what the word sets into an empty state.
#include "analyzer/machine/given_words.hpp"

#include <algorithm>
#include <array>

namespace maclint::machine {

namespace {

/// Whether positions count from elsewhere, or in another way, when a code of the group is chosen.
bool counts_positions(ModalRole role) {
    constexpr std::array others = {ModalRole::motion, ModalRole::plane, ModalRole::distance,
                                   ModalRole::feed,   ModalRole::speed, ModalRole::feed_mode,
                                   ModalRole::spindle};
    return std::ranges::find(others, role) == others.end();
}

} // namespace

Left left_by(const GivenWord& word, const ControlModel& control) {
    Left left{{}, {}, {}, word.only_switches()};
    State& state = left.state;
    state.is_reached = true;
    bool keeps_position = !word.moves && !word.changes_tool;
    for (const auto& [group, code] : word.sets) {
        const ModalRole role = control.groups[group].role;
        keeps_position &= !counts_positions(role);
        if (role != ModalRole::other) state.of(role) = Known::of(code, 0);
    }
    if (keeps_position) return left;
    state.is_moved.fill(true);
    for (Known* known : {&state.moved_in_z, &state.plunged, &state.cut}) *known = Known::nothing();
    if (word.changes_tool)
        for (Known* known : {&state.tool, &state.prepared, &state.changed, &state.length_offset,
                             &state.cutter_offset, &state.rigid_tapping})
            *known = Known::nothing();
    return left;
}

} // namespace maclint::machine
