//! A tool change under cutter compensation: a message of MAC521.
#pragma once

#include "rules/machine_check.hpp"

namespace maclint::rules {

/// At a block that changes the tool.
void check_change_under_compensation(const MachineStep& at, Reporter& reporter);

} // namespace maclint::rules
