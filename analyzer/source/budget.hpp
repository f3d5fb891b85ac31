//! How much may be looked at for one question, and whether something was left out for it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

namespace maclint {

/// A bound for all that its thread looks at while it lives: nodes of a graph, callers, reads. Who looks at
/// many asks for each; when it is spent, all that is asked afterwards has no sure answer. It belongs to the
/// thread and is not handed in: hundreds of queries would pass on what few of them ask, and who forgot to
/// would have none. docs/bounds.md lists the numbers.
class Budget {
  public:
    /// At most `most` things may be looked at.
    explicit Budget(std::size_t most)
        : left_(most)
        , outer_(std::exchange(innermost, this)) {}
    /// Nothing counts while it lives: for what has bounds of its own, or is kept for others who ask.
    [[nodiscard]] static Budget without_bound() { return Budget(std::numeric_limits<std::size_t>::max()); }
    Budget(const Budget&) = delete;
    Budget& operator=(const Budget&) = delete;
    ~Budget() {
        innermost = outer_;
        if (outer_ != nullptr) outer_->gave_up_ |= gave_up_;
    }

    [[nodiscard]] bool is_spent() const { return is_spent_; }
    /// Whether a search gave up meanwhile, by this bound or one of its own: what is found then counts for
    /// less, and something may be missing.
    [[nodiscard]] bool gave_up() const { return gave_up_; }

    /// Whether `more` things may be looked at beside those before, which then counts as done.
    [[nodiscard]] static bool allows(std::size_t more = 1) {
        if (innermost == nullptr) return true;
        innermost->is_spent_ |= more > innermost->left_;
        innermost->left_ -= std::min(more, innermost->left_);
        return !innermost->is_spent_;
    }
    /// Whether the thread's innermost is spent.
    [[nodiscard]] static bool is_innermost_spent() { return innermost != nullptr && innermost->is_spent_; }
    /// Notes that a search has met its bound.
    static void note_given_up() {
        if (innermost != nullptr) innermost->gave_up_ = true;
    }

  private:
    inline static constinit thread_local Budget* innermost = nullptr;
    std::size_t left_;
    Budget* outer_;
    bool is_spent_ = false;
    bool gave_up_ = false;
};

/// Whether one of the things has the property, each of which is looked at; false where the budget is spent.
template<class Things, class Property>
[[nodiscard]] bool any_within_budget(const Things& things, const Property& property) {
    for (const auto& thing : things) {
        if (!Budget::allows()) return false;
        if (property(thing)) return true;
    }
    return false;
}

} // namespace maclint
