//! Positions that count from the machine's zero beside those that count from the program's.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

#include <cstdint>
#include <vector>

namespace maclint::rules {

struct MixedPosition {
    enum class Kind : std::uint8_t {
        sibling,      ///< another axis of the same block, or of the same offset, takes the other kind
        target,       ///< the machine's is the end of a move in the program's coordinates
        machine_move, ///< the program's is the end of a move in the machine's coordinates
        difference,   ///< one was read before a move and the other behind it
    } kind;
    Span place;            ///< the word, the assignment, the difference
    ExpressionId position; ///< that is read
    Span other;            ///< of a sibling, and of a difference: where the other one is read
};

/// In the order of the effects; differences behind them. The facts Read and BeforeNode tell.
[[nodiscard]] std::vector<MixedPosition> find_mixed_positions(const ProgramAnalysis& analysis);

} // namespace maclint::rules
