//! Where a probe has touched, read as where the axis stands.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

#include <vector>

namespace maclint::rules {

struct PositionForTouch {
    EffectId store;          ///< #13=#5041, behind a move that a signal ends
    EffectId other;          ///< #12=#5061, behind another one
    ExpressionId difference; ///< of the two: #13-#12
};

/// Of two variables that are taken from each other, one holds where a signal has ended a move, the other
/// where the axis stood behind such a move. Each is set once, behind moves of their own. In the order of the
/// expressions, each store once.
[[nodiscard]] std::vector<PositionForTouch> find_positions_for_touches(const ProgramAnalysis& analysis);

struct PositionKeptForTouch {
    EffectId store;     ///< #500=#5041, behind a move that a signal ends
    ExpressionId asked; ///< #5061, which the program asks for to see whether there was a signal
};

/// A variable for other programs keeps where the axis stands behind a move that a signal ends; where the
/// signal came is asked for, and kept nowhere. In the order of the text.
[[nodiscard]] std::vector<PositionKeptForTouch>
find_positions_kept_for_touches(const ProgramAnalysis& analysis);

} // namespace maclint::rules
