//! Reads the program in the order of its text.
#include "analyzer/queries/values/stored_positions.hpp"

#include "analyzer/program/machine_words.hpp"
#include "analyzer/queries/machine/skip_moves.hpp"
#include "analyzer/queries/values/positions.hpp"

#include <algorithm>
#include <variant>

namespace maclint::queries {
namespace {

std::optional<StoredPosition> position_in(const Program& program, EffectId effect, const Assign& assign) {
    const VariableRange* range = position_read(program, assign.value);
    if (range == nullptr) return std::nullopt;
    const auto number = std::get<LoadMachine>(program.expressions[assign.value].node).number;
    return StoredPosition{effect, range, static_cast<std::int32_t>(number) - range->first, 0, std::nullopt};
}

} // namespace

StoredPositions::StoredPositions(const ProgramAnalysis& analysis)
    : program_(analysis.program()) {
    if (analysis.control().machine_words == nullptr || !reads_positions(program_)) return;
    const auto skips = analysis.control().machine_words->skips;
    std::size_t moves = 0;
    std::optional<flow::NodeId> ended_by_signal;
    for (flow::NodeId node = 0; node < analysis.graph().nodes_in_text; ++node) {
        if (has_move(analysis, node)) {
            ++moves;
            ended_by_signal = block_with_code(analysis, node, skips) ? std::optional(node) : std::nullopt;
        }
        const Slice effects = analysis.graph().nodes[node].effects;
        for (EffectId id = effects.first; id < effects.first + effects.count; ++id) {
            const auto* assign = std::get_if<Assign>(&program_.effects[id].what);
            const auto* target = assign == nullptr ? nullptr : std::get_if<Variable>(&assign->target);
            if (target == nullptr) continue;
            auto now = position_in(program_, id, *assign);
            if (now) {
                now->moves = moves;
                now->ended_by_signal = ended_by_signal;
            }
            const auto [known, fresh] = stored_.try_emplace(*target, now);
            if (!fresh) known->second.reset();
        }
    }
}

const StoredPosition* StoredPositions::in(ExpressionId expression) const {
    const auto* load = std::get_if<Load>(&program_.expressions[expression].node);
    const auto found = load == nullptr ? stored_.end() : stored_.find(load->variable);
    return found == stored_.end() || !found->second ? nullptr : &*found->second;
}

std::vector<std::pair<Variable, StoredPosition>> StoredPositions::shared() const {
    std::vector<std::pair<Variable, StoredPosition>> found;
    for (const auto& [variable, position] : stored_)
        if (position && program_.control->spaces[variable.space].scope != Scope::frame)
            found.emplace_back(variable, *position);
    std::ranges::sort(found, {}, [](const auto& stored) { return stored.second.effect; });
    return found;
}

} // namespace maclint::queries
