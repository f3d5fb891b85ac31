//! States in front of effects that rules want to know of.
#pragma once

#include "analyzer/dataflow/domain/state.hpp"
#include "analyzer/flow/graph.hpp"

namespace maclint::dataflow {

/// The state in front of an effect that a rule wants to know of.
struct PointState {
    flow::NodeId node;
    EffectId effect;
    State state;
};
struct BeforeToolChange : PointState {};
struct BeforeWatchedWord : PointState {}; ///< that sets a watched group

} // namespace maclint::dataflow
