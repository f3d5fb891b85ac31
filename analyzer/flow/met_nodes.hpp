//! Which nodes of a graph a walk has met.
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <vector>

namespace maclint::flow {

/// Takes time and memory for the nodes that are met, not for those of the graph: many a walk through a long
/// program ends after a few.
class MetNodes {
  public:
    /// For the nodes 0 to `nodes` - 1.
    explicit MetNodes(std::size_t nodes)
        : nodes_(nodes) {
        if (nodes <= most_cleared) by_node_.resize(nodes);
    }

    [[nodiscard]] bool contains(std::uint32_t node) const {
        return by_node_.empty() ? few_.contains(node) : by_node_[node];
    }

    void insert(std::uint32_t node) {
        if (!by_node_.empty()) {
            by_node_[node] = true;
            return;
        }
        few_.insert(node);
        if (few_.size() * share < nodes_) return;
        by_node_.resize(nodes_);
        for (const std::uint32_t met : few_) by_node_[met] = true;
        few_ = {};
    }

  private:
    /// So many bits are cleared as fast as one node is met.
    static constexpr std::size_t most_cleared = 4096;
    /// Once one node in so many is met, a bit for each pays.
    static constexpr std::size_t share = 64;

    std::size_t nodes_;
    std::unordered_set<std::uint32_t> few_; ///< while there are no bits
    std::vector<bool> by_node_;
};

} // namespace maclint::flow
