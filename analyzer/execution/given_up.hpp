//! Whether searches have met their bound: for paths, uses or callers.
#pragma once

#include "analyzer/workspace/search_memory.hpp"

#include <utility>

namespace maclint::execution {

/// Notes whether a search of its thread gives up while it lives: what is found then counts for less, and
/// something may be missing.
class GivenUp {
  public:
    GivenUp()
        : outer_(std::exchange(innermost, this)) {}
    GivenUp(const GivenUp&) = delete;
    GivenUp& operator=(const GivenUp&) = delete;
    ~GivenUp() { innermost = outer_; }
    [[nodiscard]] bool any() const { return any_; }

    /// A search through the program has met its bound.
    static void note(SearchMemory& memory) {
        memory.count(true);
        if (innermost != nullptr) innermost->any_ = true;
    }

  private:
    inline static constinit thread_local GivenUp* innermost = nullptr;
    GivenUp* outer_;
    bool any_ = false;
};

} // namespace maclint::execution
