//! Threads of the standard library: the executable says how much stack each of them has.
#include "analyzer/source/platform/threads.hpp"

#include <new>
#include <system_error>
#include <thread>
#include <utility>

namespace maclint::platform {

struct Thread::State {
    std::thread thread;
};

Thread::Thread(std::unique_ptr<State> state)
    : state_(std::move(state)) {}
Thread::Thread(Thread&&) noexcept = default;
Thread::~Thread() {
    if (state_) state_->thread.join();
}

std::optional<Thread> Thread::start(std::function<void()> work) {
    try {
        return Thread(std::make_unique<State>(State{std::thread(std::move(work))}));
    } catch (const std::system_error&) {
        return std::nullopt;
    } catch (const std::bad_alloc&) {
        return std::nullopt;
    }
}

bool has_memory_for_thread() noexcept { return true; }

bool has_memory_to_start() noexcept { return true; }

bool run_with_stack(const std::function<void()>& work) {
    work();
    return true;
}

} // namespace maclint::platform
