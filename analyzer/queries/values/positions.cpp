//! Asks the control's table.
#include "analyzer/queries/values/positions.hpp"

#include <variant>

namespace maclint::queries {

const VariableRange* position_read(const Program& program, ExpressionId expression) {
    const auto* load = std::get_if<LoadMachine>(&program.expressions[expression].node);
    const VariableRange* range =
        load == nullptr ? nullptr : program.control->families[load->family].find(load->number);
    const bool is_position = range != nullptr && (!range->positions_of.empty() || range->is_skip_position);
    return is_position ? range : nullptr;
}

} // namespace maclint::queries
