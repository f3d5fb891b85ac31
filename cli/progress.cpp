//! A thread that writes the line again five times a second.
#include "cli/progress.hpp"

#include "cli/terminal.hpp"

#include <chrono>
#include <string>

namespace maclint::cli {
namespace {

using namespace std::chrono_literals;

constexpr auto patience = 1s;
constexpr auto interval = 200ms;

void write_line(const std::string& text) {
    // To the line's beginning, erase it, write: what ECMA-48 calls CR and EL.
    print_aside("\r\x1B[K" + text);
}

} // namespace

Progress::Progress(Shown shown) {
    if (shown == Shown::never) return;
    if (auto thread = platform::Thread::start([this] { show_until_stopped(); }))
        ticker_.emplace(*std::move(thread));
}

Progress::~Progress() {
    if (!ticker_) return;
    {
        const std::lock_guard lock(mutex_);
        is_stopped_ = true;
    }
    stopped_.notify_all();
    ticker_.reset();
    if (visible_) write_line("");
}

void Progress::begin(std::string_view phase, std::size_t steps) {
    const std::lock_guard lock(mutex_);
    phase_ = phase;
    steps_ = steps;
    done_ = 0;
}

void Progress::tell(std::size_t done) const {
    constexpr std::size_t parts = 20, percent = 100;
    if (steps_ == 0 || done * parts / steps_ == (done - 1) * parts / steps_) return;
    watcher_(phase_, done * percent / steps_);
}

void Progress::show_until_stopped() {
    std::unique_lock lock(mutex_);
    const auto is_stopped_after = [&](auto time) {
        return stopped_.wait_for(lock, time, [this] { return is_stopped_; });
    };
    for (bool stopped = is_stopped_after(patience); !stopped; stopped = is_stopped_after(interval)) {
        const std::string count =
            steps_ == 0 ? "" : " " + std::to_string(done_) + " of " + std::to_string(steps_) + " files";
        write_line("maclint: " + std::string(phase_) + count + " …");
        visible_ = true;
    }
}

} // namespace maclint::cli
