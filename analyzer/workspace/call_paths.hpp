//! How one program of a workspace comes to run another.
#pragma once

#include "analyzer/flow/components.hpp"
#include "analyzer/program/model.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <vector>

namespace maclint {

class ProgramAnalysis;
struct Caller;

/// The calls that lead from one program to another, in order. Of more than `most` the first and the last ones
/// stand here, half and half.
struct CallPath {
    static constexpr std::size_t most = 8;
    std::vector<Caller> calls;
    std::size_t length = 0; ///< with those that are left out
};

/// The shortest paths of calls. A search serves all questions in a row that begin at one program, and goes
/// only as far as they want and a bound allows.
class CallPaths {
  public:
    /// The programs must outlive it.
    explicit CallPaths(const std::deque<ProgramAnalysis>& programs)
        : programs_(programs) {}

    /// Empty when no path is found or it is the same program. May be asked on several threads.
    [[nodiscard]] CallPath between(std::uint32_t from, std::uint32_t to);

  private:
    /// How a program is reached.
    struct Step {
        std::uint32_t search = 0; ///< in which
        std::uint32_t caller;
        EffectId call;
        std::uint32_t length; ///< of the path to it
        std::uint32_t near;   ///< the program on the path where the first half of what is told ends
    };
    /// Puts the calls of all programs side by side: a search that asks thousands of analyses for them waits
    /// for memory most of its time.
    void gather_calls();
    void begin(std::uint32_t from);
    /// Goes on until the program is reached, nothing is left or enough is looked at; false for these.
    [[nodiscard]] bool reach(std::uint32_t to);
    /// The last `count` calls on the path to the program.
    [[nodiscard]] std::vector<Caller> last_calls(std::uint32_t to, std::size_t count) const;

    const std::deque<ProgramAnalysis>& programs_;
    std::mutex mutex_;
    flow::SliceTable called_;  ///< by program: the programs that it calls
    flow::SliceTable effects_; ///< by program: the calls of these, in the same order
    // The search.
    std::optional<std::uint32_t> from_;
    std::uint32_t search_ = 0; ///< counts them
    std::vector<std::uint32_t> reached_;
    std::size_t next_ = 0;    ///< of these, the first whose calls are not looked at
    std::vector<Step> steps_; ///< by program
};

} // namespace maclint
