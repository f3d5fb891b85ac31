//! A whole condition, and whether it can be true and false.
#pragma once

#include "analyzer/dataflow/domain/arithmetic.hpp"
#include "analyzer/dataflow/facts/fact_set.hpp"
#include "analyzer/flow/graph.hpp"

namespace maclint::dataflow {

/// A whole condition of IF or WHILE that can be reached.
struct Condition {
    static constexpr FactPlace place{2};
    flow::NodeId node;
    EffectId effect; ///< Guarded or RegionMark
    ExpressionId expression;
    Truth truth;
};

} // namespace maclint::dataflow
