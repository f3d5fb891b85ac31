//! Of MAC562: the first move, the changes of a tool that has worked, and the ends of a program.
#include "rules/machine/demanded_place.hpp"

#include "analyzer/program/model.hpp"

#include <algorithm>
#include <variant>

namespace maclint::rules {

std::optional<DemandedBlock::Place> place_of(const MachineStep& at) {
    using machine::Move;
    using Place = DemandedBlock::Place;
    const machine::State& before = at.before();
    const bool turns_to_another = at.after().changed.is_known() &&
                                  at.after().changed.block == at.block().begin &&
                                  !(before.tool.is_known() && at.after().tool.is(before.tool.value));
    if (turns_to_another && (before.cut.is(1) || before.moved_in_z.is(1))) return Place::tool_change;
    const auto effects = at.analysis.program().effects_in(at.step.block.effects);
    const bool ends = std::ranges::any_of(effects, [](const Effect& effect) {
        const auto* stop = std::get_if<Stop>(&effect.what);
        return stop != nullptr && stop->kind == Stop::Kind::end;
    });
    if (ends) return Place::end;
    if (at.step.move == Move::none || at.step.move == Move::elsewhere) return std::nullopt;
    const bool is_first = at.told.insert(0).second; // of the program's moves
    return is_first ? std::optional(Place::start) : std::nullopt;
}

} // namespace maclint::rules
