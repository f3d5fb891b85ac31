//! Channels that wait for each other so that none goes on.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

#include <optional>

namespace maclint::queries {

/// A wait that never ends, and the one of another channel that keeps it from ending.
struct EndlessWait {
    Span wait, other;
    unsigned channel = 0, other_channel = 0;
    bool meets_nobody = false; ///< the other channel comes to no such place at all: `other` is empty
};

/// The first one, where the program's channels run their marks and meetings in the order of the text. Nothing
/// where a condition, a loop or a call may change that order, or a number is calculated.
[[nodiscard]] std::optional<EndlessWait> find_endless_wait(const ProgramAnalysis& analysis);

} // namespace maclint::queries
