//! Looks at what a program reads and never sets.
#include "analyzer/workspace/written_as_macro.hpp"

#include "analyzer/program/block_view.hpp"

#include <algorithm>
#include <variant>
#include <vector>

namespace maclint {
namespace {

std::vector<Variable> variables_set_by(const Program& program) {
    std::vector<Variable> set;
    for_each_effect(program, [&](EffectId id) {
        const auto* assign = std::get_if<Assign>(&program.effects[id].what);
        if (assign == nullptr) return;
        if (const auto* variable = std::get_if<Variable>(&assign->target)) set.push_back(*variable);
    });
    return set;
}

} // namespace

bool is_written_as_macro(const Program& program) {
    const std::vector<Variable> set = variables_set_by(program);
    const auto& formals = program.control->formals;
    const auto reads_argument = [&](const Expression& expression) {
        const auto* load = std::get_if<Load>(&expression.node);
        return load != nullptr && std::ranges::find(formals, load->variable) != formals.end() &&
               std::ranges::find(set, load->variable) == set.end();
    };
    const auto asks_for_argument = [&](const Expression& expression) {
        const auto* apply = std::get_if<Apply>(&expression.node);
        return apply != nullptr &&
               (apply->operation == Operation::is_vacant || apply->operation == Operation::is_set) &&
               std::ranges::any_of(program.operands_of(*apply), [&](ExpressionId operand) {
                   return reads_argument(program.expressions[operand]);
               });
    };
    return program.number && program.control->macro_numbers.contains(*program.number)
               ? std::ranges::any_of(program.expressions, reads_argument)
               : std::ranges::any_of(program.expressions, asks_for_argument);
}

} // namespace maclint
