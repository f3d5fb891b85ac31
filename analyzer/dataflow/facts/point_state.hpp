//! States in front of nodes and effects that rules want to know of.
#pragma once

#include "analyzer/dataflow/domain/state.hpp"
#include "analyzer/dataflow/facts/fact_set.hpp"
#include "analyzer/flow/graph.hpp"

namespace maclint::dataflow {

/// The state in front of a node, which holds for those after it, too, up to the next that has one. Nodes that
/// no path reaches have none.
struct BeforeNode {
    static constexpr FactPlace place{13};
    flow::NodeId node;
    State state;
};

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
