//! A thing that is made when somebody asks for it first.
#pragma once

#include "analyzer/source/budget.hpp"

#include <atomic>
#include <mutex>
#include <optional>

namespace maclint {

/// May be asked on several threads. Where only one asks, that costs no call of the system: std::call_once
/// wakes others each time, though nobody waits.
template<class T>
class MadeOnce {
  public:
    /// What the first `make()` gave; it is the same function in each call.
    template<class Make>
    [[nodiscard]] T& get(const Make& make) {
        if (!is_made_.load(std::memory_order_acquire)) {
            const std::scoped_lock lock(mutex_);
            if (!thing_) {
                const Budget own = Budget::without_bound(); // nobody knows who asks first
                thing_ = make();
                is_made_.store(true, std::memory_order_release);
            }
        }
        return *thing_;
    }

  private:
    std::mutex mutex_;
    std::atomic<bool> is_made_ = false;
    std::optional<T> thing_;
};

} // namespace maclint
