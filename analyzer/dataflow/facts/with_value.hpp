//! Facts about a variable that go back to one computation.
#pragma once

#include "analyzer/dataflow/facts/facts.hpp"
#include "analyzer/source/budget.hpp"

namespace maclint::dataflow {

/// Whether a fact about the variable whose value is the result of that computation has the property. What is
/// looked at are the facts about the one or the other, whichever are fewer.
template<OfAVariable T, class Property>
[[nodiscard]] bool any_with_value(const Facts& facts, Variable variable, SymbolId symbol,
                                  const Property& property) {
    const auto of_variable = facts.about<T>(variable);
    const auto of_value = facts.with<T>(symbol);
    return any_within_budget(
        of_variable.size() < of_value.size() ? of_variable : of_value, [&](const T* fact) {
            return fact->variable == variable && fact->value.symbol == symbol && property(*fact);
        });
}

} // namespace maclint::dataflow
