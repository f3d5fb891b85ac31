//! Touches that nobody asks about, beside others that are asked about.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

#include <vector>

namespace maclint::rules {

struct UncheckedTwin {
    flow::NodeId move; ///< that a signal ends
    Span move_span;
    EffectId store;          ///< #9=#5061
    EffectId checked;        ///< #8=#5061, behind a move whose end is compared
    ExpressionId calculated; ///< in which both stand: #8+#9
};

/// Two touches that are calculated with each other: behind the one, and before the next move, a condition
/// asks where it ended, behind the other none does, nor does any other ask for what it has found. In the
/// order of the expressions, each touch once.
[[nodiscard]] std::vector<UncheckedTwin> find_unchecked_twins(const ProgramAnalysis& analysis);

} // namespace maclint::rules
