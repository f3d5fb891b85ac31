//! One line on a terminal's stderr that says how far a long run is.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <string_view>
#include <thread>

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
    void show_until_stopped(const std::stop_token& stop);

    std::mutex mutex_;
    std::condition_variable_any stopped_;
    std::string_view phase_;
    std::size_t steps_ = 0;
    std::atomic<std::size_t> done_{0};
    bool visible_ = false;
    std::jthread ticker_;
};

} // namespace maclint::cli
