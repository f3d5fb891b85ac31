//! Positions that programs read by their numbers.
#pragma once

#include "analyzer/program/model.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>

namespace maclint::queries {

/// The row of the position that the expression reads: of an axis (#5041), where a signal ended a move
/// (#5061), or where the last block has ended (#5001). nullptr: it reads none.
[[nodiscard]] const VariableRange* position_read(const Program& program, ExpressionId expression);

/// Whether the program reads any: few do.
[[nodiscard]] bool reads_positions(const Program& program);

/// The read of a position that the expression, which is evaluated at the effect, is as it stands or a copy
/// of. The facts Read tell.
[[nodiscard]] std::optional<ExpressionId> copied_position(const ProgramAnalysis& analysis, EffectId effect,
                                                          ExpressionId expression);

} // namespace maclint::queries
