//! Of MAC587: what of a block is beyond the limits of the machine.
#pragma once

#include "analyzer/program/shop_demands.hpp"
#include "rules/machine_check.hpp"

namespace maclint::rules {

/// Reports each speed, feed, tool and position of the block that the limits do not allow.
void look_for_broken_limits(const MachineStep& at, const ShopLimits& limits, Reporter& reporter);

} // namespace maclint::rules
