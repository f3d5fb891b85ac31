//! Which moves are cuts whatever the spindle does.
#pragma once

#include "rules/machine_check.hpp"

namespace maclint::rules {

/// A canned cycle at a position, a turning cycle, or a line after the tool has fed down: any other move may
/// bring a stop, a pin or a probe to its place.
[[nodiscard]] bool is_surely_a_cut(const MachineStep& at);
/// Whether a program that the block calls cuts with the spindle as it is.
[[nodiscard]] bool calls_what_cuts(const MachineStep& at);

} // namespace maclint::rules
