//! Positions in the words of moves that count from where the tool is.
#pragma once

#include "analyzer/queries/modal/modes_at.hpp"

#include <vector>

namespace maclint::rules {

struct PositionAsIncrement {
    Span word;             ///< X[#10+#1]
    ExpressionId position; ///< #5041, here or where it was stored
    flow::NodeId node;
    GroupId group;      ///< of the distance mode
    queries::Mode mode; ///< in force on some path, by a word of the program
};

/// Words of lengths whose value is one position that was read, and what is added to it: where something is
/// taken away, the rest may be a distance. Of each code that is left on the first, in the order of the text.
[[nodiscard]] std::vector<PositionAsIncrement> find_positions_as_increments(const ProgramAnalysis& analysis);

} // namespace maclint::rules
