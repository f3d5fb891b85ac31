//! How much may be looked at for one question.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>

namespace maclint {

/// A bound for all that its thread looks at while it lives: nodes of a graph, callers, reads. Who looks at
/// many asks for each; when the bound is met, all that is asked afterwards has no sure answer.
class WorkLimit {
  public:
    /// So many may be looked at.
    explicit WorkLimit(std::size_t most)
        : left_(most)
        , outer_(std::exchange(innermost, this)) {}
    WorkLimit(const WorkLimit&) = delete;
    WorkLimit& operator=(const WorkLimit&) = delete;
    ~WorkLimit() { innermost = outer_; }
    [[nodiscard]] bool is_met() const { return is_met_; }

    /// Whether so many more may be looked at, which then counts as done.
    [[nodiscard]] static bool allows(std::size_t more = 1) {
        if (innermost == nullptr) return true;
        innermost->is_met_ |= more > innermost->left_;
        innermost->left_ -= std::min(more, innermost->left_);
        return !innermost->is_met_;
    }

    /// Whether the thread's innermost limit is met.
    [[nodiscard]] static bool is_innermost_met() { return innermost != nullptr && innermost->is_met_; }

    /// While it lives nothing counts: for what has a bound of its own, or is kept for others who ask.
    class Pause {
      public:
        Pause()
            : paused_(std::exchange(innermost, nullptr)) {}
        Pause(const Pause&) = delete;
        Pause& operator=(const Pause&) = delete;
        ~Pause() { innermost = paused_; }

      private:
        WorkLimit* paused_;
    };

  private:
    inline static constinit thread_local WorkLimit* innermost = nullptr;
    std::size_t left_;
    WorkLimit* outer_;
    bool is_met_ = false;
};

/// Whether one of the things has the property, each of which is looked at; false where the limit is met.
template<class Things, class Property>
[[nodiscard]] bool any_within_limit(const Things& things, const Property& property) {
    for (const auto& thing : things) {
        if (!WorkLimit::allows()) return false;
        if (property(thing)) return true;
    }
    return false;
}

} // namespace maclint
