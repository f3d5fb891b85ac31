//! A walk over the tree of an expression.
#include "analyzer/queries/machine/changing_values.hpp"

#include "analyzer/program/tables.hpp"

#include <algorithm>

namespace maclint::queries {

bool reads_what_changes(const ProgramAnalysis& analysis, ExpressionId expression) {
    const Program& program = analysis.program();
    const auto& node = program.expressions[expression].node;
    if (const auto* machine = std::get_if<LoadMachine>(&node)) {
        const VariableRange* range = analysis.control().families[machine->family].find(machine->number);
        return range == nullptr || range->changes_by_itself;
    }
    if (std::holds_alternative<LoadAt>(node)) return true;
    const auto* apply = std::get_if<Apply>(&node);
    return apply != nullptr && std::ranges::any_of(program.operands_of(*apply), [&](ExpressionId operand) {
               return reads_what_changes(analysis, operand);
           });
}

} // namespace maclint::queries
