//! Returns of a program under the limit of look-ahead that it has switched on.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

#include <optional>
#include <vector>

namespace maclint::rules {

struct LimitLeftOn {
    Offset limit;                      ///< where the block begins that switches it on
    Span end;                          ///< of the block that ends it on another way, or was to
    std::vector<flow::NodeId> returns; ///< under it, in text order
};

/// Only where the program surely returns under its own limit, or comes to a return on a way around all blocks
/// that end it, and leaves on another way with the limit ended, or has a block for that to which no path
/// leads. Nothing where it does not.
[[nodiscard]] std::optional<LimitLeftOn> limit_left_on(const ProgramAnalysis& analysis);

} // namespace maclint::rules
