//! One line on a terminal's stderr that says how far a long run is.
#pragma once

#include "analyzer/source/platform/threads.hpp"

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <string_view>
#include <utility>

namespace maclint::cli {

/// Silent unless told to show, and during the first second.
class Progress {
  public:
    enum class Shown : std::uint8_t { never, when_long };
    explicit Progress(Shown shown);
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    /// Removes the line.
    ~Progress();

    /// `phase`: "reading"; of static lifetime. 0 steps: nobody counts.
    void begin(std::string_view phase, std::size_t steps);
    void step() {
        const std::size_t done = ++done_;
        if (watcher_) tell(done);
    }

    /// Who wants to know it, too, each time when some more percent are done; called by those who step.
    using Watcher = std::function<void(std::string_view phase, std::size_t percent)>;
    void watch(Watcher watcher) { watcher_ = std::move(watcher); }

  private:
    void show_until_stopped();
    void tell(std::size_t done) const;

    std::mutex mutex_;
    std::condition_variable stopped_;
    bool is_stopped_ = false;
    std::string_view phase_;
    std::size_t steps_ = 0;
    std::atomic<std::size_t> done_{0};
    Watcher watcher_;
    bool visible_ = false;
    std::optional<platform::Thread> ticker_; ///< none: nothing is shown
};

} // namespace maclint::cli
