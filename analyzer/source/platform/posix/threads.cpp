//! POSIX threads with a stack of our own size.
#include "analyzer/source/platform/threads.hpp"

#include "analyzer/source/platform/kept_by_thread.hpp"

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <utility>

#include <pthread.h>
#include <sys/mman.h>
#include <sys/resource.h>

namespace maclint::platform {
namespace {

constexpr std::size_t mebibyte = std::size_t{1} << 20U;
/// Bytes. The deepest programs and configurations that the tests have take less than 128 KiB.
constexpr std::size_t stack_size = 2 * mebibyte;
/// Bytes of addresses that jemalloc takes for a thread's first allocation, with room to spare. It does not
/// ask whether it got them and faults.
constexpr std::size_t arena_size = 16 * mebibyte;

bool are_free(std::size_t addresses) noexcept {
    void* const room = mmap(nullptr, addresses, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    return room != MAP_FAILED && munmap(room, addresses) == 0;
}

} // namespace

struct Thread::State {
    std::function<void()> work;
    std::atomic<bool> runs = false;
    pthread_t thread = {};

    static void* run(void* argument) {
        auto* const state = static_cast<State*>(argument);
        // Now, while nobody else takes memory. NOLINTBEGIN(cppcoreguidelines-no-malloc): not optimised away
        void* volatile first = std::malloc(1);
        std::free(first);
        // NOLINTEND(cppcoreguidelines-no-malloc)
        state->runs = true;
        state->runs.notify_one();
        state->work();
        return nullptr;
    }
};

Thread::Thread(std::unique_ptr<State> state)
    : state_(std::move(state)) {}
Thread::Thread(Thread&&) noexcept = default;
Thread::~Thread() {
    if (state_) pthread_join(state_->thread, nullptr);
}

std::optional<Thread> Thread::start(std::function<void()> work) {
    auto state = std::unique_ptr<State>(new (std::nothrow) State{std::move(work)});
    if (!state || !has_memory_for_thread()) return std::nullopt;
    pthread_attr_t attributes;
    if (pthread_attr_init(&attributes) != 0) return std::nullopt;
    const bool started = pthread_attr_setstacksize(&attributes, stack_size) == 0 &&
                         pthread_create(&state->thread, &attributes, &State::run, state.get()) == 0;
    pthread_attr_destroy(&attributes);
    if (!started) return std::nullopt;
    state->runs.wait(false);
    return Thread(std::move(state));
}

bool has_memory_for_thread() noexcept { return are_free(stack_size + arena_size); }

bool has_memory_to_start() noexcept { return are_free(8 * mebibyte); }

bool run_with_stack(const std::function<void()>& work) {
    rlimit limit{};
    const bool is_small = getrlimit(RLIMIT_STACK, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY &&
                          limit.rlim_cur < stack_size;
    if (is_small)
        return Thread::start([&work] {
                   const ThreadWork keeps;
                   work();
               })
            .has_value();
    work();
    return true;
}

} // namespace maclint::platform
