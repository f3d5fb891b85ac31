//! What a search for a path is asked for, and what it finds.
#pragma once

#include "analyzer/flow/graph.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace maclint::execution {

/// A part of a path: to a node, over none of the nodes in between that are `barred` (sorted).
struct Leg {
    flow::NodeId to;
    std::span<const flow::NodeId> barred;
};

struct PathFound {
    std::optional<std::vector<flow::EdgeId>> path; ///< from the program's start
    std::vector<std::size_t> ends;                 ///< of each leg: how many edges of the path lead there
    std::size_t visits = 0;                        ///< of nodes, that it took
    bool gave_up = false;  ///< none was found among as many as were tried; there may be one
    bool may_miss = false; ///< rounds of loops that can be gone were left out: there may be one
};

} // namespace maclint::execution
