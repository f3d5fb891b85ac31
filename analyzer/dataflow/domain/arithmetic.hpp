//! Results of operators and functions as values: what semantics/ tells of them, with symbols and origins.
#pragma once

#include "analyzer/dataflow/domain/value.hpp"
#include "analyzer/semantics/concrete.hpp"
#include "analyzer/semantics/exactness.hpp"
#include "analyzer/semantics/truth.hpp"

#include <span>

namespace maclint::dataflow {

using semantics::is_comparison;
using semantics::is_inexact;
using semantics::mirrored;
using semantics::opposite;
using semantics::Truth;

/// The result of an operator or function of at least one operand. `here` is the expression, for values that
/// are rounded by it.
[[nodiscard]] Value compute(ValueTable& table, Operation operation, std::span<const Value> operands,
                            const Origin& here);

/// The outcome of a comparison; `vacant_equals_zero` is the control's.
[[nodiscard]] Truth compare(Operation operation, const Value& left, const Value& right,
                            bool vacant_equals_zero);

} // namespace maclint::dataflow
