//! What cannot be read, in parts of a program where no path leads.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

#include <vector>

namespace maclint::queries {

struct UnreachedText {
    const SyntaxError* error; ///< of the file
    Span region;              ///< all the blocks around it that nothing reaches
};

/// In text order. Parts that are never executed at all, such as lists and contours, are none.
[[nodiscard]] std::vector<UnreachedText> unreached_text(const ProgramAnalysis& analysis);

} // namespace maclint::queries
