//! Of MAC568: a length offset that only some paths choose.
#pragma once

#include "rules/machine_check.hpp"

namespace maclint::rules {

/// At a block that moves along the tool: the message is "path".
void look_for_offset_skipped(const MachineStep& at, Reporter& reporter);

} // namespace maclint::rules
