//! The order in which the solver visits nodes.
#pragma once

#include "analyzer/flow/graph.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace maclint::flow {

/// The nodes that wait to be visited. They are taken in sweeps through the text: a loop's head is not visited
/// again before the rest of the body has had its turn.
class Worklist {
  public:
    explicit Worklist(std::size_t nodes)
        : bits_(nodes / word_bits + 1, 0) {}

    void add(NodeId node) {
        bits_[node / word_bits] |= std::uint64_t{1} << node % word_bits;
        if (node < at_) lowest_ = std::min(lowest_, node);
    }

    /// The next of them, which waits no more.
    std::optional<NodeId> take() {
        if (const auto node = take_from_here()) return node;
        if (lowest_ == nothing) return std::nullopt;
        at_ = std::exchange(lowest_, nothing);
        return take_from_here();
    }

  private:
    static constexpr std::uint32_t word_bits = 64;
    static constexpr NodeId nothing = 0xFFFFFFFF;

    std::optional<NodeId> take_from_here() {
        std::size_t word = at_ / word_bits;
        std::uint64_t bits = bits_[word] & ~std::uint64_t{0} << at_ % word_bits;
        while (bits == 0) {
            if (++word == bits_.size()) return std::nullopt;
            bits = bits_[word];
        }
        const auto bit = static_cast<std::uint32_t>(std::countr_zero(bits));
        bits_[word] &= ~(std::uint64_t{1} << bit);
        const NodeId node = static_cast<NodeId>(word) * word_bits + bit;
        at_ = node + 1;
        return node;
    }

    std::vector<std::uint64_t> bits_; ///< one for every node, and at least one more
    NodeId at_ = 0;                   ///< the sweep has come so far
    NodeId lowest_ = nothing;         ///< the first that waits for the next sweep
};

} // namespace maclint::flow
