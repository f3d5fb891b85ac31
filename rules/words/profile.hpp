//! The blocks that a cycle reads its profile from.
#pragma once

#include "rules/words/row_of_block.hpp"

namespace maclint {

/// Tells of a row that encloses blocks where they are missing, stand twice or the wrong way round, or hold
/// what the row forbids. The messages are those of MAC338.
void look_at_profile(const RowOfBlock& block, Reporter& reporter);

} // namespace maclint
