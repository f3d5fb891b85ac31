//! Which programs call which: components of programs that call each other, in an order from callees to callers.
#pragma once

#include <cstdint>
#include <vector>

namespace maclint {

/// For every node the nodes that it points to.
using Arrows = std::vector<std::vector<std::uint32_t>>;

struct Components {
    std::vector<std::uint32_t> of;                    ///< component of every node
    std::vector<std::vector<std::uint32_t>> members;  ///< callees' components come before their callers'
};

/// Strongly connected components (Tarjan 1972), without recursion.
[[nodiscard]] Components find_components(const Arrows& arrows);

/// Components grouped so that all callees of a group are in earlier groups.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> layers_of(const Arrows& arrows, const Components& components);

}  // namespace maclint
