//! Asks the called programs how they begin.
#include "analyzer/machine/late_lifts.hpp"

#include "analyzer/program/machine_words.hpp"
#include "analyzer/program/tables.hpp"

#include <variant>

namespace maclint::machine {

std::vector<LateLift> find_late_lifts(const Program& program, const flow::Graph& graph, const States& states,
                                      const CalledStates& called) {
    const MachineWords* machine = program.control->machine_words;
    if (machine == nullptr || machine->tool_word_holds_offset || states.empty()) return {};
    const LiftWatch& watch = states.habits().lifts();
    std::vector<LateLift> found(watch.lifts().begin(), watch.lifts().end());
    for (const AsideBeforeCall& before : watch.before_calls()) {
        const auto node = graph.node_of(before.call);
        if (!node) continue;
        const Slice effects = graph.nodes[*node].effects;
        for (EffectId id = effects.first; id < effects.first + effects.count; ++id) {
            const bool is_call = std::holds_alternative<Call>(program.effects[id].what);
            const States* of_called = is_call ? called(id) : nullptr;
            if (of_called != nullptr && of_called->habits().lifts().begins_with_lift_of(before.aside))
                found.push_back({before.aside.block, before.aside.z_before, before.call});
        }
    }
    return found;
}

} // namespace maclint::machine
