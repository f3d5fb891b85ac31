//! Goes back from decisions to what the variables were made of.
#include "analyzer/execution/failure_reasons.hpp"

#include <variant>

namespace maclint::execution {

void FailureReasons::add_decision(const flow::Edge& edge, VariableSet& set) const {
    sets_.add_reads(edge.condition, set);
    if (!edge.label || !edge.jump) return;
    if (const auto* jump = std::get_if<Jump>(&program_.effects[*edge.jump].what))
        sets_.add_reads(jump->target, set);
}

void FailureReasons::add_returns(flow::NodeId node, VariableSet& set) const {
    const Slice effects = graph_.nodes[node].effects;
    for (EffectId id = effects.first; id < effects.first + effects.count; ++id) {
        const auto* call = std::get_if<Call>(&program_.effects[id].what);
        if (call == nullptr) continue;
        const bool shared = program_.control->calls[call->kind].frame == Frame::shared;
        for (const Variable variable : callees_(id).summary.decides_end)
            if (shared || program_.control->spaces[variable.space].scope != Scope::frame)
                sets_.add(variable, set);
    }
}

void FailureReasons::go_back_over(flow::NodeId node, VariableSet& set) const {
    const Slice effects = graph_.nodes[node].effects;
    for (EffectId id = effects.first + effects.count; id-- > effects.first;) {
        const auto* assign = std::get_if<Assign>(&program_.effects[id].what);
        if (assign == nullptr) continue;
        const auto* variable = std::get_if<Variable>(&assign->target);
        if (variable == nullptr || sets_.holds(set, *variable)) sets_.go_back_over(node, *assign, set);
    }
}

} // namespace maclint::execution
