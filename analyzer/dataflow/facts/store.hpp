//! A value that is stored in a variable.
#pragma once

#include "analyzer/dataflow/domain/value.hpp"
#include "analyzer/dataflow/facts/fact_set.hpp"
#include "analyzer/flow/graph.hpp"

#include <optional>

namespace maclint::dataflow {

/// How a store changes the variable's own value: v = v + amount, v = v - amount.
struct Step {
    Operation operation;     ///< add or subtract
    ExpressionId expression; ///< of the amount
    Value amount;
};

struct Store {
    static constexpr FactPlace place{5};
    flow::NodeId node;
    EffectId effect;
    Variable variable;
    ExpressionId expression;
    Value value;
    Value old; ///< what the variable held before
    std::optional<Step> step;
};

} // namespace maclint::dataflow
