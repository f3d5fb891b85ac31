//! Indices of arrays whose sizes are known.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

#include <cstddef>
#include <vector>

namespace maclint::queries {

/// Of arrays of the program, then of those that its files of definitions give: `declared` is empty there.
[[nodiscard]] std::vector<ArrayIndex> known_indices(const ProgramAnalysis& analysis);

/// An element with more or fewer indices than a file of definitions gives its array.
struct OtherDimensions {
    Span element;
    std::size_t wanted; ///< 0: of a single variable
};
[[nodiscard]] std::vector<OtherDimensions> other_dimensions(const ProgramAnalysis& analysis);

} // namespace maclint::queries
