//! Of MAC562: where blocks may be demanded.
#pragma once

#include "analyzer/program/shop_demands.hpp"
#include "rules/machine_check.hpp"

#include <optional>

namespace maclint::rules {

/// The place that the step is, as far as it is one; the first move of a program is one once.
[[nodiscard]] std::optional<DemandedBlock::Place> place_of(const MachineStep& at);

} // namespace maclint::rules
