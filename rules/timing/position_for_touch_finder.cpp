//! Looks at the differences of two positions.
#include "rules/timing/position_for_touch_finder.hpp"

#include "analyzer/queries/values/stored_positions.hpp"

#include <algorithm>
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

} // namespace maclint::rules
