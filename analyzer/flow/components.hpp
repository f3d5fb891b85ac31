//! Cycles in a directed graph: what can reach itself, in an order from the pointed-to to the pointing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace maclint::flow {

/// Lists of numbers, one after the other in the same memory: most are short, and there are many.
class SliceTable {
  public:
    /// Makes room for so many lists that hold so many numbers together.
    void reserve(std::size_t lists, std::size_t numbers) {
        ends_.reserve(lists);
        numbers_.reserve(numbers);
    }
    /// Adds to the list that is being made.
    void add(std::uint32_t number) { numbers_.push_back(number); }
    void end_list() { ends_.push_back(numbers_.size()); }

    [[nodiscard]] std::size_t size() const { return ends_.size(); }
    [[nodiscard]] std::span<const std::uint32_t> operator[](std::size_t list) const {
        const std::size_t begin = list == 0 ? 0 : ends_[list - 1];
        return std::span(numbers_).subspan(begin, ends_[list] - begin);
    }

  private:
    std::vector<std::uint32_t> numbers_;
    std::vector<std::size_t> ends_;
};

/// For every node the nodes that it points to.
using Adjacency = SliceTable;

struct Components {
    std::vector<std::uint32_t> of; ///< component of every node
    SliceTable members;            ///< sorted; what a component points to comes before it
};

/// Strongly connected components (Tarjan 1972), without recursion.
[[nodiscard]] Components find_components(const Adjacency& adjacency);

/// Components grouped so that everything that a group points to is in earlier groups.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> layers_of(const Adjacency& adjacency,
                                                                const Components& components);

} // namespace maclint::flow
