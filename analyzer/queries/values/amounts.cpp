//! Looks through the operands of all calculations.
#include "analyzer/queries/values/amounts.hpp"

#include <variant>

namespace maclint::queries {
namespace {

bool wants_amounts(Operation operation) {
    switch (operation) {
    case Operation::multiply:
    case Operation::divide:
    case Operation::power:
    case Operation::sine:
    case Operation::cosine:
    case Operation::tangent:
    case Operation::arc_sine:
    case Operation::arc_cosine:
    case Operation::arc_tangent:
    case Operation::arc_tangent_of_two:
    case Operation::square_root:
    case Operation::absolute:
    case Operation::logarithm:
    case Operation::exponential: return true;
    default: return false;
    }
}

/// What leaves a code a code: `IF[#33NEFIX[#33]]` finds G54.1.
bool keeps_code(Operation operation) {
    return operation == Operation::negate || operation == Operation::round ||
           operation == Operation::truncate || operation == Operation::round_up;
}

/// `#3` of `-#3` and `FIX[#3]`.
ExpressionId code_in(const Program& program, ExpressionId expression) {
    const auto* apply = std::get_if<Apply>(&program.expressions[expression].node);
    while (apply != nullptr && keeps_code(apply->operation)) {
        expression = program.operands_of(*apply).front();
        apply = std::get_if<Apply>(&program.expressions[expression].node);
    }
    return expression;
}

} // namespace

std::vector<std::optional<ExpressionId>> calculations_with_amounts(const Program& program) {
    std::vector<std::optional<ExpressionId>> found(program.expressions.size());
    for (ExpressionId id = 0; id < program.expressions.size(); ++id) {
        const auto* apply = std::get_if<Apply>(&program.expressions[id].node);
        if (apply == nullptr || !wants_amounts(apply->operation)) continue;
        for (const ExpressionId operand : program.operands_of(*apply)) found[code_in(program, operand)] = id;
    }
    return found;
}

} // namespace maclint::queries
