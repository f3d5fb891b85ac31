//! A whole condition, and whether it can be true and false.
#pragma once

#include "analyzer/dataflow/domain/arithmetic.hpp"
#include "analyzer/flow/graph.hpp"

namespace maclint::dataflow {

/// A whole condition of IF or WHILE that can be reached.
struct Condition {
    flow::NodeId node;
    EffectId effect; ///< Guarded or RegionMark
    ExpressionId expression;
    Truth truth;
};

} // namespace maclint::dataflow
