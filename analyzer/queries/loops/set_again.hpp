//! Loops that begin each round by setting back what their exits ask for.
#pragma once

#include "analyzer/dataflow/loops.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>

namespace maclint::queries {

/// Why all exits of a loop turn out the same in every round, the first included.
struct SetAgain {
    EffectId store;         ///< the assignment that every round comes by before the exit
    ExpressionId condition; ///< of the exit
};

/// Nothing where a round may differ from the one before: what an exit asks for is handed on from round to
/// round, only some rounds come by the exit, or something else than assignments of fixed values and fixed
/// steps changes it. A loop whose exits ask for nothing that it changes is none (`unchanging_deciders`).
[[nodiscard]] std::optional<SetAgain> set_again(const ProgramAnalysis& analysis, const dataflow::Loop& loop);

} // namespace maclint::queries
