//! What a run depends on and no program text tells: chosen by whoever starts the stepper.
#pragma once

#include "analyzer/program/block_view.hpp"
#include "analyzer/semantics/concrete.hpp"

#include <functional>
#include <utility>
#include <vector>

namespace maclint::execution {

using semantics::Content;

/// What a program does that the workspace does not have.
struct UnknownEffects {
    std::vector<std::pair<Variable, Content>> stores; ///< in variables of the control, or of the caller where
                                                      ///< the call shares them
    std::vector<std::pair<GroupId, double>> codes;
    bool stops = false; ///< an alarm or the program's end in it
};

/// Every function must be set.
struct Environment {
    /// What a variable holds that nothing has set yet, and that is not vacant by its scope.
    std::function<Content(const Program&, Variable)> at_start;
    /// The code or value in force before anything sets the group.
    std::function<double(GroupId)> code_at_start;
    /// The value of an expression of which the program does not tell it: a value that the machine owns, a
    /// text, a function that is not modelled, what could not be read.
    std::function<Content(const Program&, ExpressionId)> value_of;
    /// What somebody types when the program asks for the variable.
    std::function<Content(const Program&, Variable)> typed_in;
    /// Whether the switch for one of the block's skip levels is on.
    std::function<bool(const BlockView&)> skips;
    std::function<UnknownEffects(const Program&, CallKindId)> unknown_call;
};

} // namespace maclint::execution
