//! What a layer above keeps with a program for as long as rules ask about it.
#pragma once

#include <memory>
#include <mutex>

namespace maclint {

class Companion {
  public:
    /// Calls `use` with the companion, which `make` makes for the first who asks; one thread at a time. All
    /// who ask want the same type.
    template<class Thing, class Make, class Use>
    auto use(const Make& make, const Use& use_it) {
        const std::scoped_lock lock(mutex_);
        if (thing_ == nullptr) thing_ = make();
        return use_it(*static_cast<Thing*>(thing_.get()));
    }
    void forget() {
        const std::scoped_lock lock(mutex_);
        thing_.reset();
    }

  private:
    std::mutex mutex_;
    std::shared_ptr<void> thing_;
};

} // namespace maclint
