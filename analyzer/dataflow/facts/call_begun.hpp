//! What a call begins a program with that may end in an alarm.
#pragma once

#include "analyzer/dataflow/domain/known_start.hpp"
#include "analyzer/dataflow/facts/fact_set.hpp"
#include "analyzer/flow/graph.hpp"

namespace maclint::dataflow {

/// A call of a known program that ends in an alarm always, or for some of what it may be given. A modal call
/// begins it at every move.
struct CallBegun {
    static constexpr FactPlace place{14};
    flow::NodeId node;
    EffectId effect;
    KnownStart start;        ///< what is vacant; numbers are not
    KnownStart with_numbers; ///< the same with the numbers that are known; empty where none is
};

} // namespace maclint::dataflow
