//! Tools that are moved aside before they are lifted.
#pragma once

#include "analyzer/machine/states.hpp"

#include <functional>
#include <vector>

namespace maclint::machine {

/// The states of the program that a call runs; nullptr: nobody has it.
using CalledStates = std::function<const States*(EffectId call)>;

/// Of a mill: those of the program itself, then those that a called program lifts.
[[nodiscard]] std::vector<LateLift> find_late_lifts(const Program& program, const flow::Graph& graph,
                                                    const States& states, const CalledStates& called);

} // namespace maclint::machine
