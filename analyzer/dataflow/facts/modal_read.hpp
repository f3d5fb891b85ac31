//! A modal group that is read by its variable.
#pragma once

#include "analyzer/dataflow/domain/value.hpp"
#include "analyzer/dataflow/facts/fact_set.hpp"
#include "analyzer/flow/graph.hpp"

namespace maclint::dataflow {

/// A read of a modal group by its variable, and what the group can be there.
struct ModalRead {
    static constexpr FactPlace place{4};
    flow::NodeId node;
    EffectId effect;
    ExpressionId expression;
    GroupId group;
    ModalValue value;
};

} // namespace maclint::dataflow
