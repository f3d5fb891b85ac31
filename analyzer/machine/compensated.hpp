//! Stretches of a program in which cutter compensation is in force, and how the tool moves there.
#pragma once

#include "analyzer/machine/states.hpp"

#include <cstddef>
#include <vector>

namespace maclint::machine {

/// Where the compensation was switched on, and for nothing.
struct CompensationWithoutMove {
    Span block;
    double code;
    Span ended; ///< the block that ends it, or before which the program does
};
/// Compensation that ends before the tool has moved in its plane.
[[nodiscard]] std::vector<CompensationWithoutMove> compensation_without_move(const Program& program,
                                                                             const States& states);

/// Blocks in a row without a move in the plane, between two that have one, under compensation.
struct StandingBlocks {
    Span first, last;
    std::size_t count;
    Span next; ///< the move behind them
    double code;
};
[[nodiscard]] std::vector<StandingBlocks> standing_blocks(const Program& program, const States& states);

} // namespace maclint::machine
