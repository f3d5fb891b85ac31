//! Looks at the differences of two positions.
#include "rules/timing/position_for_touch_finder.hpp"

#include "analyzer/program/tables.hpp"
#include "analyzer/queries/values/positions.hpp"
#include "analyzer/queries/values/stored_positions.hpp"

#include <algorithm>
#include <cstdint>
#include <unordered_set>
#include <utility>
#include <variant>

namespace maclint::rules {

std::vector<PositionForTouch> find_positions_for_touches(const ProgramAnalysis& analysis) {
    std::vector<PositionForTouch> found;
    const queries::StoredPositions positions(analysis);
    const Program& program = analysis.program();
    for (ExpressionId id = 0; id < program.expressions.size(); ++id) {
        const auto* difference = std::get_if<Apply>(&program.expressions[id].node);
        if (difference == nullptr || difference->operation != Operation::subtract) continue;
        const auto operands = program.operands_of(*difference);
        const queries::StoredPosition* stands = positions.in(operands[0]);
        const queries::StoredPosition* touch = positions.in(operands[1]);
        if (stands == nullptr || touch == nullptr) continue;
        if (stands->range->is_skip_position) std::swap(stands, touch);
        const bool of_one_axis = stands->axis == touch->axis && !stands->range->counts_from_machine;
        if (stands->range->is_skip_position || !touch->range->is_skip_position || !of_one_axis ||
            !stands->ended_by_signal || !touch->ended_by_signal ||
            stands->ended_by_signal == touch->ended_by_signal)
            continue;
        if (std::ranges::find(found, stands->effect, &PositionForTouch::store) == found.end())
            found.push_back({stands->effect, touch->effect, id});
    }
    return found;
}

namespace {

/// The reads of a program that are asked about below.
struct Reads {
    std::unordered_set<Variable, VariableHash> variables;
    std::vector<std::pair<ExpressionId, std::int32_t>> touches; ///< with their axes, from 0 on
};

Reads reads_of(const Program& program) {
    Reads reads;
    for (ExpressionId id = 0; id < program.expressions.size(); ++id) {
        const auto& node = program.expressions[id].node;
        if (const auto* load = std::get_if<Load>(&node)) reads.variables.insert(load->variable);
        const VariableRange* range = queries::position_read(program, id);
        if (range != nullptr && range->is_skip_position)
            reads.touches.emplace_back(id, std::get<LoadMachine>(node).number - range->first);
    }
    return reads;
}

bool is_kept(const Program& program, ExpressionId read) {
    return std::ranges::any_of(program.effects, [&](const Effect& effect) {
        return std::holds_alternative<Assign>(effect.what) &&
               effect.span.contains(program.expressions[read].span.begin);
    });
}

} // namespace

std::vector<PositionKeptForTouch> find_positions_kept_for_touches(const ProgramAnalysis& analysis) {
    std::vector<PositionKeptForTouch> found;
    const auto stored = queries::StoredPositions(analysis).shared();
    if (stored.empty()) return found;
    const Program& program = analysis.program();
    const Reads reads = reads_of(program);
    for (const auto& [variable, position] : stored) {
        const bool stands = !position.range->is_skip_position && !position.range->is_block_end &&
                            !position.range->counts_from_machine;
        if (!stands || !position.ended_by_signal || reads.variables.contains(variable)) continue;
        const auto is_of_axis = [&](const auto& touch) { return touch.second == position.axis; };
        const auto asked = std::ranges::find_if(reads.touches, is_of_axis);
        const bool some_kept = std::ranges::any_of(reads.touches, [&](const auto& touch) {
            return is_of_axis(touch) && is_kept(program, touch.first);
        });
        if (asked != reads.touches.end() && !some_kept) found.push_back({position.effect, asked->first});
    }
    return found;
}

} // namespace maclint::rules
