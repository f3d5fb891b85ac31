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
    explicit CallPaths(const std::deque<ProgramAnalysis>& programs);

    /// Empty when no path is found or it is the same program. May be asked on several threads.
    [[nodiscard]] CallPath between(std::uint32_t from, std::uint32_t to);

  private:
    /// A program that the search has reached, and how.
    struct Step {
        std::uint32_t program;
        std::uint32_t before; ///< the place of its caller's step
        std::uint32_t call;   ///< of its caller's calls that lead to a program, the n-th from 0 on
    };
    /// Puts the calls of all programs side by side: a search that asks thousands of analyses for them waits
    /// for memory most of its time.
    void gather_calls();
    void begin(std::uint32_t from);
    /// Goes on until the program is reached, nothing is left or enough is looked at; false for these.
    [[nodiscard]] bool reach(std::uint32_t to);
    /// The calls on the path to the step, in order.
    [[nodiscard]] std::vector<Caller> calls_to(std::uint32_t step) const;

    const std::deque<ProgramAnalysis>& programs_;
    std::mutex mutex_;
    flow::SliceTable called_;  ///< by program: the programs that it calls
    flow::SliceTable effects_; ///< by program: the calls of these, in the same order
    // The search.
    std::optional<std::uint32_t> from_;
    std::uint32_t search_ = 0; ///< counts them
    std::vector<Step> steps_;  ///< from the first program on, breadth first
    std::size_t next_ = 0;     ///< the first step whose program's calls are not looked at
    struct Mark {
        std::uint32_t search = 0; ///< the last one that reached the program
        std::uint32_t step = 0;   ///< its place in that
    };
    std::vector<Mark> marks_; ///< by program
};

} // namespace maclint
