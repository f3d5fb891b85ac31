//! Walks over expression trees.
#include "analyzer/dataflow/conditions.hpp"

#include <algorithm>
#include <functional>

namespace maclint::dataflow {
namespace {

bool any_vacancy_test(const Program& program, ExpressionId id,
                      const std::function<bool(ExpressionId operand)>& wanted) {
    const auto* apply = std::get_if<Apply>(&program.expressions[id].node);
    if (apply == nullptr) return false;
    const auto operands = program.operands_of(*apply);
    if (apply->operation == Operation::is_vacant || apply->operation == Operation::is_set)
        return wanted(operands.front());
    return std::ranges::any_of(
        operands, [&](ExpressionId operand) { return any_vacancy_test(program, operand, wanted); });
}

} // namespace

std::optional<Place> plain_place(const Program& program, ExpressionId expression) {
    const auto* load = std::get_if<Load>(&program.expressions[expression].node);
    return load == nullptr ? std::nullopt : std::optional(load->place);
}

std::optional<ExpressionId> condition_of(const Program& program, EffectId effect) {
    if (const auto* guarded = std::get_if<Guarded>(&program.effects[effect].what)) return guarded->condition;
    if (const auto* structure = std::get_if<Structure>(&program.effects[effect].what))
        return structure->condition;
    return std::nullopt;
}

bool tests_vacancy_of(const Program& program, ExpressionId expression, Place place) {
    return any_vacancy_test(program, expression,
                            [&](ExpressionId operand) { return plain_place(program, operand) == place; });
}

bool tests_any_vacancy(const Program& program, ExpressionId expression) {
    return any_vacancy_test(program, expression, [](ExpressionId) { return true; });
}

} // namespace maclint::dataflow
