//! Of MAC533: what speaks against a profile.
#pragma once

#include "rules/machine_check.hpp"

namespace maclint::rules {

/// Reports a roughing cycle whose profile it cannot turn from where it begins: "inside", "side", "back".
void check_profile(const MachineStep& at, Reporter& reporter);

} // namespace maclint::rules
