//! Where the time of a run goes.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>

namespace maclint::cli {

/// The parts of a run. Times of parts that run on several threads are added up.
struct Timing {
    std::chrono::nanoseconds reading{}, analysis{}, rules{};
    std::size_t files = 0;    ///< that were read
    std::size_t bytes = 0;    ///< of them
    std::size_t programs = 0; ///< that were analysed
    std::size_t searches = 0; ///< for paths that the control can take
    std::size_t searches_given_up = 0;
};

/// The same while threads add to it.
class Stopwatches {
  public:
    using Clock = std::chrono::steady_clock;

    /// Adds the time from its making to its end.
    class Running {
      public:
        explicit Running(std::atomic<std::int64_t>& sum)
            : sum_(sum) {}
        Running(const Running&) = delete;
        Running& operator=(const Running&) = delete;
        ~Running() { sum_ += std::chrono::nanoseconds(Clock::now() - begin_).count(); }

      private:
        std::atomic<std::int64_t>& sum_;
        Clock::time_point begin_ = Clock::now();
    };

    std::atomic<std::int64_t> reading = 0, analysis = 0, rules = 0; ///< nanoseconds
    std::atomic<std::size_t> files = 0, bytes = 0, programs = 0, searches = 0, searches_given_up = 0;

    [[nodiscard]] Timing times() const {
        using std::chrono::nanoseconds;
        return {
            nanoseconds(reading), nanoseconds(analysis), nanoseconds(rules), files, bytes, programs, searches,
            searches_given_up};
    }
};

} // namespace maclint::cli
