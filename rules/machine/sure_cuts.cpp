//! Tells cuts from other moves at feed.
#include "rules/machine/sure_cuts.hpp"

#include <algorithm>

namespace maclint::rules {

bool is_surely_a_cut(const MachineStep& at) {
    const machine::State& now = at.after();
    if (at.letters().tool_word_holds_offset) {
        if (at.step.move == machine::Move::cycle) return true;
        const machine::Known& mode = now.of(ModalRole::feed_mode);
        return at.step.move == machine::Move::feed && mode.is(at.letters().feed_per_revolution);
    }
    if (at.step.move == machine::Move::cycle) {
        const machine::Known& cycle = now.of(ModalRole::cycle);
        return cycle.is_known() && std::ranges::find(at.letters().tapping_cycles, cycle.value) ==
                                       at.letters().tapping_cycles.end();
    }
    if (at.step.move != machine::Move::feed || (!at.step.axes[0] && !at.step.axes[1])) return false;
    return at.before().plunged.is(1);
}

bool calls_what_cuts(const MachineStep& at) {
    return std::ranges::any_of(at.called(),
                               [](const machine::Left* left) { return left->cuts_with_spindle.has_value(); });
}

} // namespace maclint::rules
