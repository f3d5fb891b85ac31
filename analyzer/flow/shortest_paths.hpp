//! Shortest paths from a program's start to each of its nodes.
#pragma once

#include "analyzer/flow/graph.hpp"

#include <optional>
#include <vector>

namespace maclint::flow {

/// Found once for all nodes: many findings ask how the control got there.
class ShortestPaths {
  public:
    /// Edges that `usable` refuses are not taken.
    ShortestPaths(const Graph& graph, const std::function<bool(EdgeId)>& usable);

    /// The edges of a path to the node, or nothing when there is none.
    [[nodiscard]] std::optional<std::vector<EdgeId>> to(const Graph& graph, NodeId node) const;

  private:
    static constexpr EdgeId not_met = 0xFFFFFFFF;
    std::vector<EdgeId> met_by_; ///< for each node the edge on which it was met first
};

} // namespace maclint::flow
