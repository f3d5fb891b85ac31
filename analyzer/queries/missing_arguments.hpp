//! Arguments that a program calculates with, and no call of it passes.
#pragma once

#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/execution/path_search.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <map>
#include <vector>

namespace maclint::queries {

/// Whether a call that gives the program local variables of its own comes to the read with the variable as it
/// has left it. What it passes decides where it goes: another call's path may be closed to it, and another
/// way open.
class ComesTo {
  public:
    ComesTo(execution::PathSearch& search, const ProgramAnalysis& analysis, const dataflow::Read& read);
    [[nodiscard]] bool operator()(const Caller& caller);

  private:
    execution::PathSearch& search_;
    const ProgramAnalysis& analysis_;
    const dataflow::Read& read_;
    std::vector<flow::NodeId> changing_; ///< nodes that may set the variable
    std::map<std::vector<flow::NodeId>, bool>
        known_; ///< of calls that go the same ways, by nodes they do not
};

struct MissingArgument {
    const dataflow::Read* read; ///< the first that calculates with it
    const Caller* call;         ///< that leaves it out and goes there, as all known ones leave it out
};

/// One for each variable that a letter of a call reaches: all known callers open a set of locals for the
/// program and leave it out, the program calculates with it as it was at the start on a path that one of them
/// goes, and nowhere compares it, or a copy, with anything.
[[nodiscard]] std::vector<MissingArgument> find_missing_arguments(const ProgramAnalysis& analysis);

} // namespace maclint::queries
