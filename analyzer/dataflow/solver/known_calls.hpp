//! Where a program comes by that is begun with what one call passes.
#pragma once

#include "analyzer/dataflow/domain/known_start.hpp"
#include "analyzer/dataflow/facts/call_begun.hpp"
#include "analyzer/dataflow/solver/analysis.hpp"
#include "analyzer/flow/graph.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace maclint::dataflow {

/// Whether a path stops at a node, at which these calls are made.
using StopsAt = std::function<bool(std::span<const CallBegun> calls)>;

/// Ways through a program that stop at some of its nodes.
class WaysAround {
  public:
    /// What is given must outlive it. `nodes` are those at which is asked whether a path stops.
    WaysAround(const Program& program, const flow::Graph& graph, const Analysis& analysis,
               std::vector<bool> nodes);

    /// Whether the program, begun so, may be left other than by an alarm, on a path that does not stop. A
    /// quick answer: it says so, too, where that is not found out.
    [[nodiscard]] bool may_leave(const KnownStart& start, const StopsAt& stops) const;

  private:
    const Program& program_;
    const flow::Graph& graph_;
    const Analysis& analysis_;
    std::vector<bool> nodes_;
    std::vector<std::uint32_t> distance_; ///< of each node to the nearest exit, in edges
};

} // namespace maclint::dataflow
