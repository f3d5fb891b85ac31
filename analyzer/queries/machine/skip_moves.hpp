//! Moves, and those that a signal ends (G31).
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

#include <optional>
#include <span>

namespace maclint::queries {

/// The block of the node that holds a G code of the list; of several the last.
[[nodiscard]] std::optional<Span> block_with_code(const ProgramAnalysis& analysis, flow::NodeId node,
                                                  std::span<const double> codes);

/// Whether a block of the node moves.
[[nodiscard]] bool has_move(const ProgramAnalysis& analysis, flow::NodeId node);

} // namespace maclint::queries
