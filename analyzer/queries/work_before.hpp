//! Whether a program has begun its work.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

namespace maclint::queries {

/// Whether some path to the node's first time moves, changes a tool, or calls a program that is known to do
/// so.
[[nodiscard]] bool may_have_worked_before(const ProgramAnalysis& analysis, flow::NodeId node);

} // namespace maclint::queries
