//! What a thread keeps from one piece of work for the next: a parser, a cache, lists with their memory.
#pragma once

#include <memory>
#include <utility>
#include <vector>

namespace maclint::platform {

/// Stands in the function that a thread runs: what the thread keeps goes with it. A `thread_local` object
/// with a destructor would not do, as GCC 12 for Windows frees its memory before it is destroyed.
class ThreadWork {
  public:
    ThreadWork()
        : outer_(std::exchange(innermost, this)) {}
    ThreadWork(const ThreadWork&) = delete;
    ThreadWork& operator=(const ThreadWork&) = delete;
    ~ThreadWork() {
        for (; !forget_.empty(); forget_.pop_back()) forget_.back()();
        innermost = outer_;
    }

  private:
    template<class T, class Owner>
    friend class KeptByThread;
    inline static constinit thread_local ThreadWork* innermost = nullptr;
    ThreadWork* outer_;
    std::vector<void (*)()> forget_;
};

/// One T a thread, made when it is first asked for. A thread without ThreadWork, such as that of `main`,
/// keeps it to the end of the run. `Owner` tells apart those of one type.
template<class T, class Owner = T>
class KeptByThread {
  public:
    template<class... Arguments>
    static T& get(Arguments&&... arguments) {
        if (kept == nullptr) {
            auto made = std::make_unique<T>(std::forward<Arguments>(arguments)...);
            if (ThreadWork::innermost != nullptr) ThreadWork::innermost->forget_.push_back(&forget);
            kept = made.release();
        }
        return *kept;
    }

  private:
    static void forget() { const std::unique_ptr<T> last(std::exchange(kept, nullptr)); }
    inline static constinit thread_local T* kept = nullptr;
};

} // namespace maclint::platform
