//! Goes through the blocks in pairs.
#include "rules/variables/dead_store_offsets_finder.hpp"

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <optional>
#include <variant>

namespace maclint::rules {
namespace {

/// The assignment to a number that keeps its value, which the block is and nothing else.
std::optional<EffectId> offset_set_in(const Program& program, ItemId item) {
    const auto block = stored_block(program, item);
    if (!block || block->effects.count != 1 || block->skip_levels != 0) return std::nullopt;
    const auto* assign = std::get_if<Assign>(&program.effects[block->effects.first].what);
    const auto* target = assign == nullptr ? nullptr : std::get_if<StoreMachine>(&assign->target);
    const VariableRange* range =
        target == nullptr ? nullptr : program.control->families[target->family].find(target->number);
    const bool keeps = range != nullptr && range->on_write == OnWrite::store && !range->changes_by_itself &&
                       !range->is_output && range->numbers_of_a_set != 0;
    return keeps ? std::optional(block->effects.first) : std::nullopt;
}

const StoreMachine& target_of(const Program& program, EffectId effect) {
    return std::get<StoreMachine>(std::get<Assign>(program.effects[effect].what).target);
}

/// Whether the expression may read it: an index may mean any.
bool may_read(const Program& program, ExpressionId id, const StoreMachine& offset) {
    const auto& node = program.expressions[id].node;
    if (const auto* load = std::get_if<LoadMachine>(&node))
        return load->family == offset.family && load->number == offset.number;
    const auto* apply = std::get_if<Apply>(&node);
    return std::holds_alternative<LoadAt>(node) ||
           (apply != nullptr && std::ranges::any_of(program.operands_of(*apply), [&](ExpressionId operand) {
                return may_read(program, operand, offset);
            }));
}

bool has_number(const Program& program, ItemId item) {
    const auto* block = std::get_if<Block>(&program.items[item]);
    return block != nullptr && block->sequence_number.has_value();
}

} // namespace

std::vector<OffsetSetTwice> find_offsets_set_twice(const Program& program) {
    std::vector<OffsetSetTwice> found;
    std::optional<EffectId> before;
    for (ItemId item = 0; item < program.items.size(); ++item) {
        const auto now = offset_set_in(program, item);
        if (before && now && !has_number(program, item)) { // a jump may lead to a number
            const StoreMachine& first = target_of(program, *before);
            const StoreMachine& second = target_of(program, *now);
            if (first.family == second.family && first.number == second.number &&
                !may_read(program, std::get<Assign>(program.effects[*now].what).value, first))
                found.push_back({*before, *now});
        }
        before = now;
    }
    return found;
}

} // namespace maclint::rules
