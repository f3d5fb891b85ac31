//! Which nodes of a graph a walk has met.
#pragma once

#include "analyzer/source/platform/kept_by_thread.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace maclint::flow {

/// Takes time for the nodes that are met, not for those of the graph: many a walk through a long program ends
/// after a few. The thread keeps the memory for its next walk.
class MetNodes {
  public:
    /// For the nodes 0 to `nodes` - 1.
    explicit MetNodes(std::size_t nodes)
        : marks_(taken_from_thread()) {
        if (marks_->walk_of.size() < nodes)
            marks_->walk_of.resize(std::max(nodes, 2 * marks_->walk_of.size()), 0);
        if (++marks_->walk != 0) return;
        std::ranges::fill(marks_->walk_of, 0);
        marks_->walk = 1;
    }
    MetNodes(const MetNodes&) = delete;
    MetNodes& operator=(const MetNodes&) = delete;
    ~MetNodes() { Kept::get().free.push_back(std::move(marks_)); } // there is room for all that were made

    [[nodiscard]] bool contains(std::uint32_t node) const { return marks_->walk_of[node] == marks_->walk; }
    void insert(std::uint32_t node) { marks_->walk_of[node] = marks_->walk; }

  private:
    struct Marks {
        std::vector<std::uint32_t> walk_of; ///< of every node: the last walk that has met it
        std::uint32_t walk = 0;             ///< the number of the present one, from 1
    };
    /// Within a step of a walk another one may begin.
    struct AllMarks {
        std::vector<std::unique_ptr<Marks>> free; ///< those of walks that have ended
        std::size_t made = 0;
    };
    using Kept = platform::KeptByThread<AllMarks>;

    static std::unique_ptr<Marks> taken_from_thread() {
        AllMarks& all = Kept::get();
        if (all.free.empty()) {
            all.free.reserve(all.made + 1);
            auto marks = std::make_unique<Marks>();
            ++all.made;
            return marks;
        }
        auto marks = std::move(all.free.back());
        all.free.pop_back();
        return marks;
    }

    std::unique_ptr<Marks> marks_;
};

} // namespace maclint::flow
