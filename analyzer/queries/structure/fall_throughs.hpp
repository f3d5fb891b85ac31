//! Branches of a selection that go on into the next one.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

#include <vector>

namespace maclint::queries {

/// A branch whose last block does not leave the selection.
struct FallThrough {
    EffectId branch; ///< the word that begins it: CASE
    EffectId next;   ///< and the one that begins the branch into which it goes on
};

/// In the order of selections, of each in the order of its branches. Selections without their close are left
/// out, and branches without a block, which share that of the next one.
[[nodiscard]] std::vector<FallThrough> find_fall_throughs(const ProgramAnalysis& analysis);

} // namespace maclint::queries
