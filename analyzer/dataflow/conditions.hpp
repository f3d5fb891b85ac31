//! Questions about expressions and conditions that more than one rule asks.
#pragma once

#include "analyzer/dataflow/facts.hpp"

#include <optional>

namespace maclint::dataflow {

/// The variable that the expression is, and nothing else.
[[nodiscard]] std::optional<Place> plain_place(const Program& program, ExpressionId expression);

/// The whole condition of the IF or WHILE that is this effect; nothing for other effects.
[[nodiscard]] std::optional<ExpressionId> condition_of(const Program& program, EffectId effect);

/// Whether the expression or a part of it asks if the variable is vacant.
[[nodiscard]] bool tests_vacancy_of(const Program& program, ExpressionId expression, Place place);

/// Whether the condition holds a vacancy test of whatever.
[[nodiscard]] bool tests_any_vacancy(const Program& program, ExpressionId expression);

} // namespace maclint::dataflow
