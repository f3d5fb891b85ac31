//! How a program is left.
#pragma once

#include "analyzer/dataflow/domain/state.hpp"
#include "analyzer/dataflow/facts/fact_set.hpp"
#include "analyzer/flow/graph.hpp"

namespace maclint::dataflow {

/// The state with which the program is left.
struct ExitState {
    static constexpr FactPlace place{12};
    flow::Exit exit;
    State state;
};

} // namespace maclint::dataflow
