//! Looks at what a program reads and never sets.
#include "analyzer/workspace/written_as_macro.hpp"

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <unordered_map>
#include <variant>

namespace maclint {
namespace {

/// Of each variable that a block sets, the first place that does. A program may set any number of names.
using FirstStores = std::unordered_map<Variable, Offset, VariableHash>;

FirstStores first_stores(const Program& program) {
    FirstStores stores;
    for_each_effect(program, [&](EffectId id) {
        const auto* assign = std::get_if<Assign>(&program.effects[id].what);
        if (assign == nullptr) return;
        const auto* variable = std::get_if<Variable>(&assign->target);
        if (variable != nullptr) stores.try_emplace(*variable, program.effects[id].span.begin);
    });
    return stores;
}

/// Whether a letter of a call reaches the variable, and no block above sets it.
bool reads_argument(const Program& program, const FirstStores& stores, ExpressionId id) {
    const Expression& expression = program.expressions[id];
    const auto& formals = program.control->formals;
    const auto* load = std::get_if<Load>(&expression.node);
    if (load == nullptr || std::ranges::find(formals, load->variable) == formals.end()) return false;
    const auto store = stores.find(load->variable);
    return store == stores.end() || expression.span.begin < store->second;
}

} // namespace

std::optional<ExpressionId> find_macro_argument(const Program& program) {
    const FirstStores stores = first_stores(program);
    const bool numbered = program.number && program.control->macro_numbers.contains(*program.number);
    for (ExpressionId id = 0; id < program.expressions.size(); ++id) {
        if (numbered && reads_argument(program, stores, id)) return id;
        const auto* apply = std::get_if<Apply>(&program.expressions[id].node);
        if (apply == nullptr ||
            (apply->operation != Operation::is_vacant && apply->operation != Operation::is_set))
            continue;
        for (const ExpressionId operand : program.operands_of(*apply))
            if (reads_argument(program, stores, operand)) return operand;
    }
    return std::nullopt;
}

} // namespace maclint
