//! Expressions that make the number of a variable: `#[…]`.
#pragma once

#include "analyzer/program/model.hpp"

#include <variant>

namespace maclint {

/// Calls `visit(ExpressionId)` for what stands in the brackets, of reads first, then of stores.
template<class Visit>
void for_each_index(const Program& program, const Visit& visit) {
    for (const Expression& expression : program.expressions)
        if (const auto* load = std::get_if<LoadAt>(&expression.node)) visit(load->index);
    for (const Effect& effect : program.effects)
        if (const auto* assign = std::get_if<Assign>(&effect.what))
            if (const auto* store = std::get_if<StoreAt>(&assign->target)) visit(store->index);
}

} // namespace maclint
