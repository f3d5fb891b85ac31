//! Threads whose stack holds what maclint's deepest recursion takes, whatever the shell or the system says.
#pragma once

#include <functional>
#include <memory>
#include <optional>

namespace maclint::platform {

/// A thread that is waited for when this goes.
class Thread {
  public:
    /// Starts the work on a thread that has all it needs, an arena of the allocator included. Nothing: there
    /// is no memory for it, or the system gives no more threads. While one is started, others allocate
    /// nothing large.
    [[nodiscard]] static std::optional<Thread> start(std::function<void()> work);
    Thread(Thread&&) noexcept;
    Thread& operator=(Thread&&) = delete;
    ~Thread();

  private:
    struct State;
    explicit Thread(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// Whether there is memory for one more thread; the allocator does not ask, and faults.
[[nodiscard]] bool has_memory_for_thread() noexcept;

/// Whether there is memory for what is done before `main`.
[[nodiscard]] bool has_memory_to_start() noexcept;

/// Does the work on this thread, or on another one where the stack of this one is too small. False: there is
/// no memory for another, and nothing was done.
[[nodiscard]] bool run_with_stack(const std::function<void()>& work);

} // namespace maclint::platform
