//! One look at all stores and conditions.
#include "analyzer/queries/deliberate_conditions.hpp"

#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/store.hpp"

#include <algorithm>
#include <optional>
#include <variant>

namespace maclint::queries {
namespace {

std::optional<Label> jump_target(const Program& program, EffectId effect) {
    const auto* guarded = std::get_if<Guarded>(&program.effects[effect].what);
    if (guarded == nullptr || guarded->effects.count != 1) return std::nullopt;
    const auto* jump = std::get_if<Jump>(&program.effects[guarded->effects.first].what);
    return jump == nullptr ? std::nullopt : flow::constant_target(program, jump->target);
}

/// What the condition guards: IF[#1GT#2]THEN#1=#2 makes sure, whether it is needed or not.
bool only_clamps(const ProgramAnalysis& analysis, const dataflow::Condition& condition,
                 const dataflow::ReadSet& reads) {
    const Program& program = analysis.program();
    const auto* guarded = std::get_if<Guarded>(&program.effects[condition.effect].what);
    if (guarded == nullptr) return false;
    return std::ranges::any_of(program.effects_in(guarded->effects), [&](const Effect& effect) {
        const auto* assign = std::get_if<Assign>(&effect.what);
        const auto* variable = assign == nullptr ? nullptr : std::get_if<Variable>(&assign->target);
        return variable != nullptr && std::ranges::find(reads.variables, *variable) != reads.variables.end();
    });
}

struct Sides {
    bool constant = true; ///< all are known numbers
    bool vacant = false;  ///< one has never been set
    bool open = true;     ///< no comparison is decided by itself: #1LT8 OR #1GT6
};

Sides sides_of(const ProgramAnalysis& analysis, const dataflow::Condition& condition) {
    Sides sides;
    for (const auto& comparison : analysis.facts().at<dataflow::Comparison>(condition.effect)) {
        sides.open &= comparison.truth.can_hold && comparison.truth.can_fail;
        for (const dataflow::Value* value : {&comparison.left, &comparison.right}) {
            sides.constant &= value->constant().has_value();
            sides.vacant |= value->vacancy == dataflow::Vacancy::vacant;
        }
    }
    return sides;
}

} // namespace

DeliberateConditions::DeliberateConditions(const ProgramAnalysis& analysis)
    : analysis_(analysis) {
    const Program& program = analysis.program();
    for (const dataflow::Store& store : analysis.facts().all<dataflow::Store>()) {
        Assigned& assigned = assigned_[dataflow::key_of(store.variable)];
        ++assigned.count;
        assigned.literal &= std::holds_alternative<Literal>(program.expressions[store.expression].node);
    }
    for (const dataflow::Condition& condition : analysis.facts().all<dataflow::Condition>())
        if (const auto target = jump_target(program, condition.effect))
            first_tests_.try_emplace(*target, condition.node);
}

bool DeliberateConditions::may_be_meant(const dataflow::Condition& condition) const {
    const Sides sides = sides_of(analysis_, condition);
    const dataflow::ReadSet reads = dataflow::variables_of(analysis_.program(), condition.expression);
    if (sides.open) return false;
    if (sides.constant) return depends_on_settings(reads);
    if (only_clamps(analysis_, condition, reads) || repeats_another(condition)) return true;
    if (reads_setting(reads)) return true;
    // What is left over after all other cases were tested may be tested once more.
    return condition.truth.can_hold || sides.vacant;
}

/// Everything that is read is set at most once, or a number that users edit decides.
bool DeliberateConditions::depends_on_settings(const dataflow::ReadSet& reads) const {
    return reads_setting(reads) || std::ranges::all_of(reads.variables, [this](Variable variable) {
               return assigned(variable).count <= 1;
           });
}

/// A number that users edit in the program's head decides.
bool DeliberateConditions::reads_setting(const dataflow::ReadSet& reads) const {
    return std::ranges::any_of(reads.variables, [this](Variable variable) {
        return assigned(variable).count == 1 && assigned(variable).literal;
    });
}

/// An earlier test sends to the same place: the second is not needed, but does no harm.
bool DeliberateConditions::repeats_another(const dataflow::Condition& condition) const {
    const auto target = jump_target(analysis_.program(), condition.effect);
    return target && first_tests_.at(*target) < condition.node;
}

DeliberateConditions::Assigned DeliberateConditions::assigned(Variable variable) const {
    const auto found = assigned_.find(dataflow::key_of(variable));
    return found == assigned_.end() ? Assigned{} : found->second;
}

} // namespace maclint::queries
