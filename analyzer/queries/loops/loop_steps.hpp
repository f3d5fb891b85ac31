//! Why the step of a counter never ends its loop.
#pragma once

#include "analyzer/queries/loops/loop_counter.hpp"
#include "analyzer/queries/values/passed_values.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace maclint::queries {

enum class StepFault : std::uint8_t {
    none,              ///< or nobody knows
    vacant,            ///< it may be vacant, and counts as 0 then
    zero,              ///< it is 0
    wrong_sign,        ///< it leads away from every bound
    wrong_sign_passed, ///< the same for what a known call passes
};

/// A loop that may never end for want of a step.
struct EndlessCounter {
    Counter counter;
    StepFault fault; ///< of the first step; any that is right would end the loop, and none is
};

/// The first known call that passes such an amount of the step that it leads away from the loop's end.
[[nodiscard]] std::optional<PassedValue>
call_that_leads_away(const ProgramAnalysis& analysis, const Counter& counter, const dataflow::Step& step);

/// The loops that nothing but their counter can end and whose every step has a fault; of several with one
/// first step the first. A step by a variable that nothing can have set is no fault here: it is vacant
/// whatever the loop does.
[[nodiscard]] std::vector<EndlessCounter> find_endless_counters(const ProgramAnalysis& analysis);

} // namespace maclint::queries
