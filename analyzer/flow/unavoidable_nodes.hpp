//! Nodes that no path through a program leads around.
#pragma once

#include "analyzer/flow/graph.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace maclint::flow {

/// For each of so many nodes whether every path from the first of them to an exit comes by. Alarms are no
/// such exits, unless no path leads to another one; where no path leads to any, no node is unavoidable. `out`
/// holds the edges by the nodes that they leave.
[[nodiscard]] std::vector<bool> unavoidable_nodes(std::size_t nodes, std::span<const Edge> edges,
                                                  const EdgesByNode& out, std::span<const Exit> exits);

} // namespace maclint::flow
