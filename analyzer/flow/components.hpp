//! Cycles in a directed graph: what can reach itself, in an order from the pointed-to to the pointing.
#pragma once

#include <cstdint>
#include <vector>

namespace maclint::flow {

/// For every node the nodes that it points to.
using Arrows = std::vector<std::vector<std::uint32_t>>;

struct Components {
    std::vector<std::uint32_t> of;                   ///< component of every node
    std::vector<std::vector<std::uint32_t>> members; ///< what a component points to comes before it
};

/// Strongly connected components (Tarjan 1972), without recursion.
[[nodiscard]] Components find_components(const Arrows& arrows);

/// Components grouped so that everything that a group points to is in earlier groups.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> layers_of(const Arrows& arrows,
                                                                const Components& components);

} // namespace maclint::flow
