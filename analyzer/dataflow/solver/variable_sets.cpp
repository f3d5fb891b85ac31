//! Numbers the variables of a program, and finds those that an expression reads.
#include "analyzer/dataflow/solver/variable_sets.hpp"

#include "analyzer/program/overloaded.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <bit>
#include <variant>

namespace maclint::dataflow {

VariableSets::VariableSets(const Program& program, const flow::Graph& graph)
    : program_(program)
    , graph_(graph) {
    const auto number = [&](Variable variable) {
        const Variable meant = program.meant_by(variable);
        if (places_.try_emplace(meant, variables_.size()).second) variables_.push_back(meant);
    };
    for (const Expression& expression : program.expressions)
        if (const auto* load = std::get_if<Load>(&expression.node)) number(load->variable);
    for (const Effect& effect : program.effects)
        if (const auto* assign = std::get_if<Assign>(&effect.what))
            if (const auto* variable = std::get_if<Variable>(&assign->target)) number(*variable);
}

std::vector<Variable> VariableSets::members(const VariableSet& set) const {
    std::vector<Variable> all;
    for (std::size_t word = 0; word < set.size(); ++word)
        for (std::uint64_t rest = set[word]; rest != 0; rest &= rest - 1)
            all.push_back(variables_[word * word_bits + static_cast<std::size_t>(std::countr_zero(rest))]);
    return all;
}

void VariableSets::add_reads(std::optional<ExpressionId> id, VariableSet& set) const {
    if (!id) return;
    std::visit(overloaded{
                   [&](const Load& load) { add(load.variable, set); },
                   [&](const LoadAt& load) {
                       add_reads(load.index, set);
                       add_if(set, [&](SpaceId space) { return reaches(load.family, space); });
                   },
                   [&](const Apply& apply) {
                       for (const ExpressionId operand : program_.operands_of(apply)) add_reads(operand, set);
                   },
                   [](const auto&) {},
               },
               program_.expressions[*id].node);
}

void VariableSets::go_back_over(flow::NodeId node, const Assign& store, VariableSet& set) const {
    if (const auto* variable = std::get_if<Variable>(&store.target))
        replace(node, *variable, set);
    else if (const auto* indexed = std::get_if<StoreAt>(&store.target))
        add_reads(indexed->index, set);
    add_reads(store.value, set);
}

/// What it held before is no longer asked for, when the store surely is one in this variable alone.
void VariableSets::replace(flow::NodeId node, Variable variable, VariableSet& set) const {
    const VariableSpace& space = program_.control->spaces[variable.space];
    const bool may_be_another = space.named && space.scope != Scope::frame;
    if (may_be_another || graph_.channels_at(node).running != graph_.all_channels) return;
    const std::size_t place = places_.at(program_.meant_by(variable));
    set[place / word_bits] &= ~bit(place);
}

/// Whether an index into the family can mean variables of the space.
bool VariableSets::reaches(FamilyId family, SpaceId id) const {
    return std::ranges::any_of(program_.control->families[family].ranges, [&](const VariableRange& range) {
        return range.meaning == Meaning::variable && range.space == id;
    });
}

} // namespace maclint::dataflow
