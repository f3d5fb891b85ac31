//! Counts the changes under each mode.
#include "analyzer/machine/kept_modes.hpp"

#include <array>

namespace maclint::machine {
namespace {

constexpr std::array roles = {ModalRole::local_offset, ModalRole::scaling, ModalRole::rotation,
                              ModalRole::mirror_image, ModalRole::polar_coordinates};

bool moves_in_plane(const Step& step) {
    const bool moves = step.move == Move::rapid || step.move == Move::feed || step.move == Move::cycle;
    return step.calls || (moves && (step.axes[0] || step.axes[1]));
}

/// Whether the block turns to another work offset than one that the program has chosen itself.
bool changes_offset(const Step& step) {
    const Known& before = step.before.of(ModalRole::work_offset);
    const Known& after = step.after.of(ModalRole::work_offset);
    return before.is_known() && after.is_known() && before.value != after.value;
}

bool changes_tool(const Step& step) {
    const Known& changed = step.after.changed;
    return step.changes_tool && changed.is_known() && changed.block == step.block.span.begin;
}

} // namespace

void KeptModes::see(const Step& step, const ControlModel& control) {
    for (const ModalRole role : roles)
        if (step.before.of(role).is_known() || step.after.of(role).is_known()) see_mode(step, control, role);
}

void KeptModes::see_mode(const Step& step, const ControlModel& control, ModalRole role) {
    const Known& before = step.before.of(role);
    const Known& after = step.after.of(role);
    const bool was_on = is_surely_on(step.before, control, role) && !before.by_call;
    const bool is_on = is_surely_on(step.after, control, role) && !after.by_call;
    if (!was_on && !is_on) return;
    if (was_on && sets(control, step.block, role)) {
        Stretch& ended = stretches_[{role, before.block}];
        ended.waiting.reset(); // it is meant for what comes now
        ended.is_ended |= after.is_known() && !is_on;
    }
    if (!is_on) return;
    Stretch& stretch = stretches_[{role, after.block}];
    const bool of_tools = changes_tool(step);
    if (was_on && before.block == after.block && (of_tools || changes_offset(step)))
        stretch.waiting = KeptMode{role, after, step.block.span.begin, of_tools};
    if (!stretch.waiting || !moves_in_plane(step)) return;
    ++(stretch.waiting->is_of_tools ? stretch.tools : stretch.offsets);
    first_moves_.emplace(step.block.span.begin, *stretch.waiting);
    stretch.waiting.reset();
}

bool KeptModes::is_meant(const KeptMode& kept) const {
    const auto changes = [&](const Stretch& stretch) {
        return kept.is_of_tools ? stretch.tools : stretch.offsets;
    };
    int keeping = 0, others = 0;
    for (const auto& [key, stretch] : stretches_) {
        if (key.first != kept.role) continue;
        if (changes(stretch) > 0)
            ++keeping;
        else if (stretch.is_ended)
            ++others;
    }
    if (others > 0) return keeping > others;
    // One shift for a row of work offsets has several of them behind it.
    const Stretch& stretch = stretches_.at({kept.role, kept.mode.block});
    const bool is_forgotten = kept.role == ModalRole::local_offset && !kept.is_of_tools && stretch.is_ended &&
                              keeping == 1 && stretch.offsets == 1;
    return !is_forgotten;
}

std::optional<KeptMode> KeptModes::at(Offset block) const {
    const auto found = first_moves_.find(block);
    return found == first_moves_.end() || is_meant(found->second) ? std::nullopt
                                                                  : std::optional(found->second);
}

} // namespace maclint::machine
