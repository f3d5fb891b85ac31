//! Of MAC568: a tool of a lathe that cuts without its offset.
#pragma once

#include "rules/machine_check.hpp"

namespace maclint::rules {

/// T0100 behind T0101, or T0300 where all other tools have an offset when they cut: the message is
/// "taken_back".
void look_for_offset_taken_back(const MachineStep& at, Reporter& reporter);

} // namespace maclint::rules
