//! Variables that hold a position as it was read.
#pragma once

#include "analyzer/program/tables.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace maclint::queries {

/// The one assignment to a variable, of a position as it stands: #12=#5061.
struct StoredPosition {
    EffectId effect;
    const VariableRange* range;                  ///< of the position
    std::int32_t axis;                           ///< from 0 on
    std::size_t moves;                           ///< how many nodes before it in the text move
    std::optional<flow::NodeId> ended_by_signal; ///< the last of them, where a signal ends it (G31)
};

class StoredPositions {
  public:
    explicit StoredPositions(const ProgramAnalysis& analysis);

    /// What the variable that is the expression holds; nullptr for all other expressions, and for variables
    /// that are set twice or to anything else.
    [[nodiscard]] const StoredPosition* in(ExpressionId expression) const;

    /// All of them that variables hold which programs share, in the order of the text.
    [[nodiscard]] std::vector<std::pair<Variable, StoredPosition>> shared() const;

  private:
    const Program& program_;
    std::unordered_map<Variable, std::optional<StoredPosition>, VariableHash> stored_;
};

} // namespace maclint::queries
