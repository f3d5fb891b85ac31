//! One line on a terminal's stderr that says how far a long run is.
#pragma once

#include "analyzer/source/platform/threads.hpp"

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <optional>
#include <string_view>

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
    void step() { ++done_; }

  private:
    void show_until_stopped();

    std::mutex mutex_;
    std::condition_variable stopped_;
    bool is_stopped_ = false;
    std::string_view phase_;
    std::size_t steps_ = 0;
    std::atomic<std::size_t> done_{0};
    bool visible_ = false;
    std::optional<platform::Thread> ticker_; ///< none: nothing is shown
};

} // namespace maclint::cli
