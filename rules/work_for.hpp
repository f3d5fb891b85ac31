//! What a rule may look at before it is stopped.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

#include <cstddef>

namespace maclint {

/// Nodes, callers, reads and the like that are looked at in one file or program.
constexpr std::size_t most_work = 2'000'000;
constexpr std::size_t work_for_a_node = 100; ///< more for each node of a program's graph

[[nodiscard]] constexpr std::size_t work_for(const ProgramFile&) { return most_work; }
[[nodiscard]] inline std::size_t work_for(const ProgramAnalysis& program) {
    return most_work + work_for_a_node * program.graph().nodes.size();
}

} // namespace maclint
