//! Variables that something else than an assignment may have changed.
#pragma once

#include "analyzer/dataflow/facts/fact_set.hpp"
#include "analyzer/flow/graph.hpp"

#include <optional>

namespace maclint::dataflow {

/// Something other than an assignment may have changed variables: a call, an unreadable block, a store
/// through an index that can be many.
struct Clobber {
    static constexpr FactPlace place{6};
    flow::NodeId node;
    EffectId effect;
    SpaceId space;
    std::optional<Variable> variable;    ///< empty: any variable of the space
    std::optional<Variable> spared = {}; ///< but not this one

    [[nodiscard]] bool may_change(Variable which) const {
        return variable ? *variable == which : space == which.space && spared != which;
    }
};

} // namespace maclint::dataflow
