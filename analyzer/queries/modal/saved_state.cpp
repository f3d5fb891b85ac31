//! Looks at the assignments of modal states, and at who reads what they store.
#include "analyzer/queries/modal/saved_state.hpp"

#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/modal/own_settings.hpp"
#include "analyzer/queries/values/copies.hpp"

#include <algorithm>
#include <variant>

namespace maclint::queries {
namespace {

bool is_put_back_by_custom(const ModalGroup& group) {
    switch (group.restore_policy) {
    case RestorePolicy::state: return group.role != ModalRole::units;
    case RestorePolicy::value:
    case RestorePolicy::motion: return true;
    default: return false;
    }
}

/// Whether the read does no more with a saved value than to put it back or to hand it on.
bool only_hands_on(const dataflow::Read& read) {
    return read.use == dataflow::Use::word || read.use == dataflow::Use::copy ||
           read.use == dataflow::Use::argument;
}

/// Numbers of the variables of that space that expressions and assignments name.
std::vector<std::int32_t> numbers_named(const Program& program, SpaceId space) {
    std::vector<std::int32_t> named;
    const auto note = [&](Variable variable) {
        if (variable.space == space) named.push_back(variable.number);
    };
    for (const Expression& expression : program.expressions)
        if (const auto* load = std::get_if<Load>(&expression.node)) note(load->variable);
    for (const Effect& effect : program.effects)
        if (const auto* assign = std::get_if<Assign>(&effect.what))
            if (const auto* variable = std::get_if<Variable>(&assign->target)) note(*variable);
    std::ranges::sort(named);
    return named;
}

} // namespace

std::vector<const dataflow::Store*> saves_of(const ProgramAnalysis& analysis) {
    std::vector<const dataflow::Store*> saves;
    for (const dataflow::Store& store : analysis.facts().all<dataflow::Store>()) {
        const auto group = saved_group(analysis, store);
        if (group && is_put_back_by_custom(analysis.control().groups[*group])) saves.push_back(&store);
    }
    if (saves.empty()) return saves;
    std::vector<const dataflow::Store*> used;
    for (const dataflow::Read& read : analysis.facts().all<dataflow::Read>())
        if (!only_hands_on(read)) used.push_back(store_of(analysis, read.value));
    std::ranges::sort(used);
    std::erase_if(saves, [&](const dataflow::Store* save) { return std::ranges::binary_search(used, save); });
    return saves;
}

bool keeps_callers_state(const ProgramAnalysis& analysis) { return !saves_of(analysis).empty(); }

const dataflow::Store* find_save(const ProgramAnalysis& analysis, GroupId group) {
    const auto stores = analysis.facts().all<dataflow::Store>();
    const auto save = std::ranges::find_if(stores, [&](const dataflow::Store& store) {
        return saved_group(analysis, store) == group &&
               last_settings_before(analysis, store.node, group).empty();
    });
    const bool only =
        save != stores.end() && std::ranges::count(stores, save->variable, &dataflow::Store::variable) == 1;
    return only ? &*save : nullptr;
}

std::optional<Variable> find_free_local(const Program& program) {
    const ControlModel& control = *program.control;
    const auto reaches = [&](Variable variable) {
        return std::ranges::find(control.formals, variable) != control.formals.end();
    };
    for (const VariableFamily& family : control.families)
        for (const VariableRange& range : family.ranges) {
            if (range.meaning != Meaning::variable || control.spaces[range.space].scope != Scope::frame)
                continue;
            const std::vector<std::int32_t> named = numbers_named(program, range.space);
            std::optional<Variable> reached;
            for (std::int32_t number = range.last; number >= range.first; --number) {
                if (std::ranges::binary_search(named, number)) continue;
                const Variable variable{range.space, number};
                if (!reaches(variable)) return variable;
                if (!reached) reached = variable;
            }
            return reached;
        }
    return std::nullopt;
}

} // namespace maclint::queries
