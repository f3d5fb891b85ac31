//! One look at all stores and conditions.
#include "rules/numbers/deliberate_conditions.hpp"

#include "analyzer/dataflow/facts/store.hpp"

#include <algorithm>
#include <optional>

namespace maclint::rules {
namespace {

std::optional<Label> jump_target(const Program& program, EffectId effect) {
    const auto* guarded = std::get_if<Guarded>(&program.effects[effect].what);
    if (guarded == nullptr || guarded->effects.count != 1) return std::nullopt;
    const auto* jump = std::get_if<Jump>(&program.effects[guarded->effects.first].what);
    return jump == nullptr ? std::nullopt : flow::constant_target(program, jump->target);
}

} // namespace

DeliberateConditions::DeliberateConditions(const ProgramAnalysis& analysis)
    : program_(analysis.program()) {
    for (const dataflow::Store& store : analysis.facts().all<dataflow::Store>()) {
        Assigned& assigned = assigned_[dataflow::key_of(store.variable)];
        ++assigned.count;
        assigned.literal &= std::holds_alternative<Literal>(program_.expressions[store.expression].node);
    }
    for (const dataflow::Condition& condition : analysis.facts().all<dataflow::Condition>())
        if (const auto target = jump_target(program_, condition.effect))
            first_tests_.try_emplace(*target, condition.node);
}

bool DeliberateConditions::depends_on_settings(const dataflow::ReadSet& reads) const {
    return reads_setting(reads) || std::ranges::all_of(reads.variables, [this](Variable variable) {
               return assigned(variable).count <= 1;
           });
}

bool DeliberateConditions::reads_setting(const dataflow::ReadSet& reads) const {
    return std::ranges::any_of(reads.variables, [this](Variable variable) {
        return assigned(variable).count == 1 && assigned(variable).literal;
    });
}

bool DeliberateConditions::repeats_another(const dataflow::Condition& condition) const {
    const auto target = jump_target(program_, condition.effect);
    return target && first_tests_.at(*target) < condition.node;
}

DeliberateConditions::Assigned DeliberateConditions::assigned(Variable variable) const {
    const auto found = assigned_.find(dataflow::key_of(variable));
    return found == assigned_.end() ? Assigned{} : found->second;
}

} // namespace maclint::rules
