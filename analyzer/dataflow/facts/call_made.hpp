//! A call that runs a program.
#pragma once

#include "analyzer/dataflow/facts/fact_set.hpp"
#include "analyzer/flow/graph.hpp"

namespace maclint::dataflow {

/// A call that runs a program here.
struct CallMade {
    static constexpr FactPlace place{7};
    flow::NodeId node;
    EffectId effect;
    bool known;    ///< false: it is unknown what it does
    bool may_stop; ///< it may end in an alarm, a pause or the program's end; true when unknown
};

} // namespace maclint::dataflow
