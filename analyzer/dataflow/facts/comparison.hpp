//! A comparison or vacancy test, and what is known of it.
#pragma once

#include "analyzer/dataflow/domain/arithmetic.hpp"
#include "analyzer/dataflow/domain/value.hpp"
#include "analyzer/dataflow/facts/fact_set.hpp"
#include "analyzer/flow/graph.hpp"

namespace maclint::dataflow {

/// A comparison or vacancy test that can be reached.
struct Comparison {
    static constexpr FactPlace place{1};
    flow::NodeId node;
    EffectId effect;
    ExpressionId expression;
    Operation operation;
    ExpressionId left_expression;
    ExpressionId right_expression; ///< vacancy tests: the same as left
    Value left;
    Value right; ///< vacancy tests: the same as left
    Truth truth;
};

} // namespace maclint::dataflow
