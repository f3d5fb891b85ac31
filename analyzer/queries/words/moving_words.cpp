//! Looks at the effects and words of a block.
#include "analyzer/queries/words/moving_words.hpp"

#include <algorithm>
#include <variant>

namespace maclint::queries {

std::optional<EffectId> words_of_move(const Program& program, const BlockView& block) {
    std::optional<EffectId> words;
    bool moves = false;
    for (EffectId id = block.effects.first; id < block.effects.first + block.effects.count; ++id) {
        const auto& what = program.effects[id].what;
        if (std::holds_alternative<EvaluateWords>(what)) words = id;
        const auto* motion = std::get_if<Motion>(&what);
        moves |= motion != nullptr && !motion->to_reference && !motion->without_feed;
    }
    return moves ? words : std::nullopt;
}

bool counts_from_machine(const MachineWords& machine, const Word& word) {
    const auto* code = std::get_if<Literal>(&word.value);
    return code != nullptr && word.address == "G" &&
           std::ranges::find(machine.of_machine, code->value) != machine.of_machine.end();
}

} // namespace maclint::queries
