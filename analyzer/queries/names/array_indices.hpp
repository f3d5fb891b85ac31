//! Indices of arrays whose sizes are known.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

#include <vector>

namespace maclint::queries {

/// Of arrays of the program, then of those that its files of definitions give: `declared` is empty there.
[[nodiscard]] std::vector<ArrayIndex> known_indices(const ProgramAnalysis& analysis);

} // namespace maclint::queries
