//! Goes back from decisions to what the variables were made of.
#include "analyzer/execution/failure_reasons.hpp"

#include "analyzer/program/tables.hpp"

#include <variant>

namespace maclint::execution {

VariableSet FailureReasons::none() const {
    VariableSet set = sets_.none();
    work_.allows(set.size());
    return set;
}

std::vector<Variable> FailureReasons::members(const VariableSet& set) const {
    std::vector<Variable> all = sets_.members(set);
    work_.allows(set.size() + all.size());
    return all;
}

void FailureReasons::add_all(VariableSet& to, const VariableSet& from) const {
    work_.allows(to.size());
    dataflow::VariableSets::add_all(to, from);
}

void FailureReasons::add_decision(const flow::Edge& edge, VariableSet& set) const {
    add_reads(edge.condition, set);
    if (!edge.label || !edge.jump) return;
    if (const auto* jump = std::get_if<Jump>(&program_.effects[*edge.jump].what))
        add_reads(jump->target, set);
}

void FailureReasons::add_reads(std::optional<ExpressionId> id, VariableSet& set) const {
    if (!id) return;
    work_.allows(size_of(*id));
    sets_.add_reads(id, set);
}

/// In expressions.
std::size_t FailureReasons::size_of(ExpressionId id) const {
    const auto* apply = std::get_if<Apply>(&program_.expressions[id].node);
    std::size_t size = 1;
    if (apply != nullptr)
        for (const ExpressionId operand : program_.operands_of(*apply)) size += size_of(operand);
    return size;
}

void FailureReasons::add_returns(flow::NodeId node, VariableSet& set) const {
    const Slice effects = graph_.nodes[node].effects;
    for (EffectId id = effects.first; id < effects.first + effects.count; ++id) {
        const auto* call = std::get_if<Call>(&program_.effects[id].what);
        if (call == nullptr) continue;
        work_.allows(callees_(id).summary.decides_end.size() + 1);
        const bool shared = program_.control->calls[call->kind].frame == Frame::shared;
        for (const Variable variable : callees_(id).summary.decides_end)
            if (shared || program_.control->spaces[variable.space].scope != Scope::frame)
                sets_.add(variable, set);
    }
}

void FailureReasons::go_back_over(flow::NodeId node, VariableSet& set) const {
    const Slice effects = graph_.nodes[node].effects;
    work_.allows(effects.count);
    for (EffectId id = effects.first + effects.count; id-- > effects.first;) {
        const auto* assign = std::get_if<Assign>(&program_.effects[id].what);
        if (assign == nullptr) continue;
        const auto* variable = std::get_if<Variable>(&assign->target);
        if (variable != nullptr && !sets_.holds(set, *variable)) continue;
        work_.allows(size_of(assign->value));
        sets_.go_back_over(node, *assign, set);
    }
}

} // namespace maclint::execution
