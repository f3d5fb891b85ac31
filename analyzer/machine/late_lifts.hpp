//! Tools that are moved aside before they are lifted.
#pragma once

#include "analyzer/machine/states.hpp"

#include <functional>
#include <vector>

namespace maclint::machine {

/// A rapid move aside with the tool as deep as it has cut, and the block behind it that lifts the tool.
struct LateLift {
    Span block;
    double z;  ///< where the tool stands, in the program's unit, below 0
    Span lift; ///< in this program, or the call of the one that lifts
};

/// The states of the program that a call runs; nullptr: nobody has it.
using CalledStates = std::function<const States*(EffectId call)>;

/// Of a mill: behind a cut, X and Y move at rapid traverse, then Z alone goes up to 0 or higher, and there
/// the tool goes down again where it stands; or all of them return to the reference position in this order.
/// In the order of the text.
[[nodiscard]] std::vector<LateLift> find_late_lifts(const Program& program, const flow::Graph& graph,
                                                    const States& states, const CalledStates& called);

} // namespace maclint::machine
