//! How far a block moves, where the text beside it says it.
#pragma once

#include "analyzer/queries/modal/modes_at.hpp"

#include <optional>
#include <span>

namespace maclint::rules {

/// A move along one axis.
struct AxisMove {
    char axis; ///< of U on a lathe X
    double length;
};

/// Of a block whose only axis word is a number: its length under G91, or from the last number of that axis in
/// one of the few blocks before, where nothing but moves stands between. Nothing: it moves otherwise, or
/// nobody knows how far. Wants dataflow::BeforeNode.
[[nodiscard]] std::optional<AxisMove> single_move(const ProgramAnalysis& analysis, queries::ModesAt& modes_at,
                                                  const BlockView& block, std::span<const Word> words);

} // namespace maclint::rules
