//! Asks the control's table.
#include "analyzer/queries/values/positions.hpp"

#include "analyzer/dataflow/facts/read.hpp"

#include <algorithm>
#include <variant>

namespace maclint::queries {

const VariableRange* position_read(const Program& program, ExpressionId expression) {
    const auto* load = std::get_if<LoadMachine>(&program.expressions[expression].node);
    const VariableRange* range =
        load == nullptr ? nullptr : program.control->families[load->family].find(load->number);
    const bool is_position =
        range != nullptr && (!range->positions_of.empty() || range->is_skip_position || range->is_block_end);
    return is_position ? range : nullptr;
}

bool reads_positions(const Program& program) {
    for (ExpressionId id = 0; id < program.expressions.size(); ++id)
        if (position_read(program, id) != nullptr) return true;
    return false;
}

std::optional<ExpressionId> copied_position(const ProgramAnalysis& analysis, EffectId effect,
                                            ExpressionId expression) {
    const Program& program = analysis.program();
    if (position_read(program, expression) != nullptr) return expression;
    if (!std::holds_alternative<Load>(program.expressions[expression].node)) return std::nullopt;
    const auto reads = analysis.facts().at<dataflow::Read>(effect);
    const auto read = std::ranges::find(reads, expression, &dataflow::Read::expression);
    if (read == reads.end()) return std::nullopt;
    const auto made = analysis.data().table().symbols[read->value.symbol].expression();
    if (!made || *made >= program.expressions.size()) return std::nullopt;
    const auto of_copy = static_cast<ExpressionId>(*made);
    return position_read(program, of_copy) != nullptr ? std::optional(of_copy) : std::nullopt;
}

} // namespace maclint::queries
