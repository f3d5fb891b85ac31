//! What searches for paths through a program keep for each other, and how many there were.
#pragma once

#include "analyzer/source/budget.hpp"

#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>

namespace maclint {

struct SearchCounts {
    std::size_t searches = 0;
    std::size_t gave_up = 0; ///< met their bound before they found a path or that there is none
};

/// The layer that searches stands above the one that knows programs: what it keeps is a thing of its own type
/// here. May be asked on several threads.
class SearchMemory {
  public:
    /// Calls `search` with what is kept, which `make` makes for the first; one thread at a time. All who ask
    /// want the same type.
    template<class Kept, class Make, class Search>
    auto use(const Make& make, const Search& search) {
        const std::scoped_lock lock(mutex_);
        if (kept_ == nullptr) kept_ = make();
        return search(*static_cast<Kept*>(kept_.get()));
    }
    /// One more search, which the thread's Budget learns of where it gave up.
    void count(bool gave_up) {
        ++searches_;
        if (!gave_up) return;
        ++gave_up_;
        Budget::note_given_up();
    }
    [[nodiscard]] SearchCounts counts() const { return {searches_, gave_up_}; }
    /// What is kept goes, the counts stay.
    void forget() {
        const std::scoped_lock lock(mutex_);
        kept_.reset();
    }

  private:
    std::mutex mutex_;
    std::shared_ptr<void> kept_;
    std::atomic<std::size_t> searches_ = 0, gave_up_ = 0;
};

} // namespace maclint
