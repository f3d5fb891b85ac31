//! What MAC522 says of arcs whose sizes are variables.
#pragma once

#include "rules/machine_check.hpp"

namespace maclint::rules {

/// Nothing where the sizes may make a circle, or are those of one call.
void report_wrong_sizes(const MachineStep& at, Reporter& reporter);

} // namespace maclint::rules
