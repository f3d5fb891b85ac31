//! Holds what decides over the callee's alarms against what the loop changes.
#include "analyzer/dataflow/loop_stops.hpp"

#include "analyzer/dataflow/domain/read_set.hpp"

#include <algorithm>

namespace maclint::dataflow {
namespace {

/// Whether what the call passes for the variable may be another number in another round. What it leaves out
/// is always vacant.
bool passes_other_numbers(const Program& program, const Call& call, Variable variable,
                          const LoopChanges& changes) {
    return std::ranges::any_of(program.arguments_of(call), [&](const Argument& argument) {
        const auto* letter = std::get_if<Variable>(&argument.given);
        if (letter == nullptr) return true; // only the workspace knows what it means
        if (*letter != variable) return false;
        const ReadSet reads = variables_of(program, argument.value);
        return !reads.closed ||
               std::ranges::any_of(reads.variables, [&](Variable read) { return changes.may_change(read); });
    });
}

} // namespace

bool may_stop_later(const Program& program, const Analysis& analysis, const CallMade& made,
                    const LoopChanges& changes) {
    if (!made.may_stop || !made.known) return made.may_stop;
    const StopReasons& reasons = analysis.callee(made.effect).summary.stop_reasons;
    if (reasons.anything) return true;
    const auto& call = std::get<Call>(program.effects[made.effect].what);
    const bool shared_frame = program.control->calls[call.kind].frame == Frame::shared;
    return std::ranges::any_of(reasons.variables, [&](Variable variable) {
        const VariableSpace& space = program.control->spaces[variable.space];
        if (space.named) return true; // numbered differently in each program
        if (space.scope == Scope::frame && !shared_frame)
            return passes_other_numbers(program, call, variable, changes);
        return changes.may_change(variable);
    });
}

} // namespace maclint::dataflow
