//! How one program of a workspace comes to run another.
#pragma once

#include "analyzer/flow/components.hpp"
#include "analyzer/program/model.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <unordered_map>
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

/// The shortest paths of calls. A search from one program serves all questions that begin there, and goes
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
        std::uint32_t caller;
        EffectId call;
        std::uint32_t length; ///< of the path to it
        std::uint32_t near;   ///< the program on the path where the first half of what is told ends
    };
    struct Search {
        std::unordered_map<std::uint32_t, Step> reached;
        std::deque<std::uint32_t> pending;
        std::size_t looked_at = 0; ///< programs
    };
    /// Puts the calls of all programs side by side: a search that asks thousands of analyses for them waits
    /// for memory most of its time.
    void gather_calls();
    /// Goes on until the program is reached, nothing is left or enough is looked at; nullptr for these.
    [[nodiscard]] const Step* reach(Search& search, std::uint32_t from, std::uint32_t to);
    /// The last `count` calls on the path to the program.
    [[nodiscard]] static std::vector<Caller> last_calls(const Search& search, std::uint32_t to,
                                                        std::size_t count);

    const std::deque<ProgramAnalysis>& programs_;
    std::mutex mutex_;
    flow::SliceTable called_;  ///< by program: the programs that it calls
    flow::SliceTable effects_; ///< by program: the calls of these, in the same order
    std::unordered_map<std::uint32_t, Search> searches_; ///< by the program where they begin
};

} // namespace maclint
