//! The words of blocks that move.
#pragma once

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/machine_words.hpp"

#include <optional>

namespace maclint::queries {

/// The effect that calculates words of a block that moves to where they say; nothing where none is
/// calculated, the block does not move, runs to a reference position or waits.
[[nodiscard]] std::optional<EffectId> words_of_move(const Program& program, const BlockView& block);

/// Whether the word is a code by which those beside it count from the machine's own zero (G53).
[[nodiscard]] bool counts_from_machine(const MachineWords& machine, const Word& word);

} // namespace maclint::queries
