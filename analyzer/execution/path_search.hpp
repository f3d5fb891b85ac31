//! Looks for a path that the control can take.
#pragma once

#include "analyzer/execution/path_found.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <cstddef>
#include <span>

namespace maclint::execution {

class PathSearch {
  public:
    /// The analysis must outlive the search, and hold the facts Store and Clobber.
    explicit PathSearch(const ProgramAnalysis& analysis)
        : analysis_(&analysis) {}

    /// A path from the program's start along all legs. Each of its edges can be taken by a run that came this
    /// way. Loops on it are left after any number of rounds. A loop with a barred node is passed without a
    /// round. May be asked on several threads, each with a search of its own.
    [[nodiscard]] PathFound find(std::span<const Leg> legs);

  private:
    const ProgramAnalysis* analysis_;
    std::size_t visits_ = 0;
};

} // namespace maclint::execution
