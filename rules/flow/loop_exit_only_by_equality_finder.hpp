//! Loops that end only where their counter is exactly its bound, and never is.
#pragma once

#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/loops/loop_counter.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>
#include <vector>

namespace maclint::rules {

struct MissedBound {
    const dataflow::Loop* loop;
    const dataflow::Store* step;
    const dataflow::Comparison* test; ///< the first that would end the loop
    double start, amount, bound;
    std::optional<Caller> call; ///< that passes the bound; nothing: it is a number of the program
};

/// Of loops whose counter alone decides their end, by tests for equality: those in which steps of one number
/// lead from the start past the bound.
[[nodiscard]] std::vector<MissedBound> find_missed_bounds(const ProgramAnalysis& analysis);

} // namespace maclint::rules
