//! Work offsets of one axis that are made of where another axis is.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

#include <vector>

namespace maclint::rules {

/// An assignment that sets the offset of an axis by nothing but positions of another.
struct PositionOfAnotherAxis {
    EffectId effect;
    ExpressionId position; ///< #5061, here or where it was stored
    Variable meant;        ///< the same position of the offset's own axis: #5062
    Variable base;         ///< a number of the offset's axis: #5222
};

/// Of `#5222=#5222+#5061`, and of `#[5222+20*#1]=#5061`, in programs that read the position of the right axis
/// as well: they have asked for it. A statement that takes numbers of the other axis's offset exchanges the
/// two on purpose, and turned parts ask for more than one axis. In the order of the text.
[[nodiscard]] std::vector<PositionOfAnotherAxis>
find_positions_of_other_axes(const ProgramAnalysis& analysis);

} // namespace maclint::rules
