//! A modal group that is set.
#pragma once

#include "analyzer/dataflow/domain/value.hpp"
#include "analyzer/dataflow/facts/fact_set.hpp"
#include "analyzer/flow/graph.hpp"

#include <optional>

namespace maclint::dataflow {

/// A modal group set by a block that is not plain.
struct ModalWrite {
    static constexpr FactPlace place{8};
    flow::NodeId node;
    EffectId effect;
    std::optional<GroupId> group; ///< as written, or as the value decides; empty: unknown
    bool stated;                  ///< the word names the group (F#4); otherwise the value decides (G#3)
    ExpressionId expression;
    Value value;
};

} // namespace maclint::dataflow
