//! States in front of effects that rules want to know of.
#pragma once

#include "analyzer/dataflow/domain/state.hpp"
#include "analyzer/dataflow/facts/fact_set.hpp"
#include "analyzer/flow/graph.hpp"

namespace maclint::dataflow {

/// The state in front of an effect that a rule wants to know of.
struct PointState {
    flow::NodeId node;
    EffectId effect;
    State state;
};
struct BeforeToolChange : PointState {
    static constexpr FactPlace place{10};
};
struct BeforeWatchedWord : PointState { ///< that sets a watched group
    static constexpr FactPlace place{11};
};

} // namespace maclint::dataflow
