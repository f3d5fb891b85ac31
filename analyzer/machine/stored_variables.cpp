//! Looks at every assignment of a program.
#include "analyzer/machine/stored_variables.hpp"

#include <variant>

namespace maclint::machine {
namespace {

const Load* plain_load(const Program& program, ExpressionId expression) {
    return std::get_if<Load>(&program.expressions[expression].node);
}

} // namespace

StoredVariables::StoredVariables(const Program& program) {
    for (const Effect& effect : program.effects) {
        const auto* assign = std::get_if<Assign>(&effect.what);
        const auto* target = assign == nullptr ? nullptr : std::get_if<Variable>(&assign->target);
        if (target == nullptr) continue;
        const auto* mode = std::get_if<LoadModal>(&program.expressions[assign->value].node);
        const std::optional<GroupId> group = mode == nullptr ? std::nullopt : std::optional(mode->group);
        const auto [known, fresh] = groups_.try_emplace(program.meant_by(*target), group);
        if (!fresh && known->second != group) known->second.reset();
    }
}

std::optional<GroupId> StoredVariables::saved_group(const Program& program, ExpressionId expression) const {
    const Load* load = plain_load(program, expression);
    if (load == nullptr) return std::nullopt;
    const auto known = groups_.find(program.meant_by(load->variable));
    return known == groups_.end() ? std::nullopt : known->second;
}

std::optional<Variable> StoredVariables::passed(const Program& program, ExpressionId expression) const {
    const Load* load = plain_load(program, expression);
    if (load == nullptr || !program.is_formal(load->variable)) return std::nullopt;
    const Variable variable = program.meant_by(load->variable);
    return groups_.contains(variable) ? std::nullopt : std::optional(variable);
}

} // namespace maclint::machine
