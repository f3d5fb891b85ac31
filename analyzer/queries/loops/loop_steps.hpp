//! Why the step of a counter never ends its loop.
#pragma once

#include "analyzer/queries/loops/loop_counter.hpp"

#include <cstdint>
#include <vector>

namespace maclint::queries {

enum class StepFault : std::uint8_t {
    none,       ///< or nobody knows
    vacant,     ///< it may be vacant, and counts as 0 then
    zero,       ///< it is 0
    wrong_sign, ///< it leads away from every bound
};

/// A loop that may never end for want of a step.
struct EndlessCounter {
    Counter counter;
    StepFault fault; ///< of the first step; any that is right would end the loop, and none is
};

/// The loops that nothing but their counter can end and whose every step has a fault; of several with one
/// first step the first. A step by a variable that nothing can have set is no fault here: it is vacant
/// whatever the loop does.
[[nodiscard]] std::vector<EndlessCounter> find_endless_counters(const ProgramAnalysis& analysis);

} // namespace maclint::queries
