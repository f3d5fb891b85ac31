//! Looks into the indices of a program.
#include "rules/variables/value_for_number_finder.hpp"

#include "analyzer/program/tables.hpp"

#include <optional>
#include <variant>

namespace maclint::rules {
namespace {

bool is_kept_by_the_machine(const Program& program, ExpressionId id) {
    const auto* load = std::get_if<LoadMachine>(&program.expressions[id].node);
    const VariableRange* range =
        load == nullptr ? nullptr : program.control->families[load->family].find(load->number);
    return range != nullptr && range->on_write == OnWrite::store && !range->changes_by_itself &&
           !range->is_bit;
}

bool is_variable(const Program& program, ExpressionId id) {
    return std::holds_alternative<Load>(program.expressions[id].node);
}

/// The value in a sum of it and a variable.
std::optional<ExpressionId> value_in(const Program& program, ExpressionId index) {
    const auto* sum = std::get_if<Apply>(&program.expressions[index].node);
    if (sum == nullptr || sum->operation != Operation::add) return std::nullopt;
    const auto operands = program.operands_of(*sum);
    if (is_kept_by_the_machine(program, operands[0]) && is_variable(program, operands[1])) return operands[0];
    if (is_kept_by_the_machine(program, operands[1]) && is_variable(program, operands[0])) return operands[1];
    return std::nullopt;
}

} // namespace

std::vector<ValueForNumber> find_values_for_numbers(const Program& program) {
    std::vector<ValueForNumber> found;
    const auto look_at = [&](ExpressionId index) {
        if (const auto value = value_in(program, index)) found.push_back({index, *value});
    };
    for (const Expression& expression : program.expressions)
        if (const auto* load = std::get_if<LoadAt>(&expression.node)) look_at(load->index);
    for (const Effect& effect : program.effects)
        if (const auto* assign = std::get_if<Assign>(&effect.what))
            if (const auto* store = std::get_if<StoreAt>(&assign->target)) look_at(store->index);
    return found;
}

} // namespace maclint::rules
