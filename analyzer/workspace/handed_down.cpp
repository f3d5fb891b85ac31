//! Goes from callers to callees once, and shares what they have in common.
#include "analyzer/workspace/handed_down.hpp"

#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <utility>

namespace maclint {
namespace {

using dataflow::Key;

bool hands_down(const ControlModel& control) {
    return std::ranges::any_of(control.spaces, &VariableSpace::handed_down);
}

std::pair<SpaceId, std::int32_t> place_of(Variable variable) { return {variable.space, variable.number}; }

/// Sorted, each once.
void put_in_order(std::vector<Variable>& variables) {
    std::ranges::sort(variables, {}, place_of);
    const auto twice = std::ranges::unique(variables);
    variables.erase(twice.begin(), twice.end());
}

std::vector<Variable> given_by(const Program& program) {
    std::vector<Variable> variables = program.handed_down;
    put_in_order(variables);
    return variables;
}

} // namespace

HandedDown::HandedDown(const std::deque<ProgramAnalysis>& programs, const flow::Components& components)
    : components_(components) {
    if (std::ranges::all_of(
            programs, [](const ProgramAnalysis& analysis) { return analysis.program().handed_down.empty(); }))
        return;
    above_.resize(components.members.size());
    std::vector<Given> below(components.members.size());
    for (std::uint32_t component = static_cast<std::uint32_t>(above_.size()); component-- > 0;) {
        Given& above = above_[component];
        const auto members = components.members[component];
        for (const ProgramIndex member : members)
            for (const Caller& caller : programs[member].callers()) {
                const Given& more = below[components.of[caller.program]];
                above.numbered = map_.united(above.numbered, more.numbered);
                above.named = map_.united(above.named, more.named);
            }
        Given own;
        for (const ProgramIndex member : members) add(programs[member].program(), own);
        below[component] = {map_.united(above.numbered, own.numbered), map_.united(above.named, own.named)};
        if (members.size() > 1) circles_.emplace(component, own);
    }
}

void HandedDown::add(const Program& giver, Given& given) {
    for (Variable variable : given_by(giver)) {
        const bool named = giver.control->spaces[variable.space].named;
        if (named)
            variable.number =
                names_.try_emplace(giver.names[variable.number], static_cast<std::int32_t>(names_.size()))
                    .first->second;
        const Key key = dataflow::key_of(variable);
        Root& root = named ? given.named : given.numbered;
        root = map_.set(root, key, map_.find(root, key).value_or(0) + 1);
    }
}

std::optional<std::vector<Variable>> HandedDown::to(const ProgramAnalysis& taker) const {
    if (taker.callers().empty()) return std::nullopt;
    std::vector<Variable> variables;
    if (above_.empty() || !hands_down(taker.control())) return variables;
    const std::uint32_t component = components_.of[taker.index()];
    const Program& program = taker.program();
    const Given& above = above_[component];
    const auto circle = circles_.find(component);
    const Given around = circle == circles_.end() ? Given{} : circle->second;
    const std::vector<Variable> own = circle == circles_.end() ? std::vector<Variable>{} : given_by(program);
    const auto take = [&](Variable variable, Root from_above, Root from_circle, Key key) {
        const auto givers = map_.find(from_circle, key).value_or(0);
        const bool itself = std::ranges::binary_search(own, place_of(variable), {}, place_of);
        if (map_.find(from_above, key) || givers > (itself ? 1U : 0U)) variables.push_back(variable);
    };
    for (const Root root : {above.numbered, around.numbered})
        map_.for_each(root, [&](Key key, std::uint32_t) {
            take(dataflow::variable_of(key), above.numbered, around.numbered, key);
        });
    const bool names = above.named != 0 || around.named != 0;
    const auto& spaces = taker.control().spaces;
    for (std::int32_t number = 0; names && !program.names[number].empty(); ++number)
        if (const auto known = names_.find(program.names[number]); known != names_.end())
            for (SpaceId space = 0; space < spaces.size(); ++space)
                if (spaces[space].named && spaces[space].handed_down)
                    take({space, number}, above.named, around.named,
                         dataflow::key_of(Variable{space, known->second}));
    put_in_order(variables);
    return variables;
}

} // namespace maclint
