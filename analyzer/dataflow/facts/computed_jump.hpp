//! A jump to a label that is calculated.
#pragma once

#include "analyzer/dataflow/domain/value.hpp"
#include "analyzer/dataflow/facts/fact_set.hpp"
#include "analyzer/flow/graph.hpp"

namespace maclint::dataflow {

/// A jump whose target is computed.
struct ComputedJump {
    static constexpr FactPlace place{9};
    flow::NodeId node;
    EffectId effect;
    Value target;
};

} // namespace maclint::dataflow
