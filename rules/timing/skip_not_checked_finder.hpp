//! Offsets made of positions where a signal should have ended a move.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

#include <vector>

namespace maclint::rules {

/// An offset that is what it is whether the probe has touched or not.
struct UncheckedTouch {
    flow::NodeId move; ///< that a signal ends
    Span move_span;
    EffectId use; ///< makes an offset of the position
    flow::NodeId used_in;
    Span read; ///< of the position
};

/// The first for each such move, in text order. Nothing where the program compares a position or an input
/// anywhere; and none where something stands between that may have asked: a decision, a call, a function of
/// the machine, a block that cannot be read.
[[nodiscard]] std::vector<UncheckedTouch> find_unchecked_touches(const ProgramAnalysis& analysis);

} // namespace maclint::rules
