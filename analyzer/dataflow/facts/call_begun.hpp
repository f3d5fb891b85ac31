//! What a call begins a program with.
#pragma once

#include "analyzer/dataflow/domain/known_start.hpp"
#include "analyzer/dataflow/facts/fact_set.hpp"
#include "analyzer/flow/graph.hpp"

namespace maclint::dataflow {

/// A call of a known program of which it matters what it is given: it ends in an alarm for some of it, or
/// passes it on to one that does, or makes words of it. So does one that always ends in an alarm. A modal
/// call begins it at every move.
struct CallBegun {
    static constexpr FactPlace place{14};
    flow::NodeId node;
    EffectId effect;
    KnownStart start;        ///< what is vacant; numbers are not
    KnownStart with_numbers; ///< the same with the numbers that are known; empty where none is
};

} // namespace maclint::dataflow
