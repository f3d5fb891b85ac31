//! Goes from callees to callers for what is stored, and back for what is there when a program begins.
#include "analyzer/workspace/callers_locals.hpp"

#include "analyzer/dataflow/solver/index_reach.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <optional>

namespace maclint {
namespace {

constexpr std::size_t most_locals = 64, most_calls = 64; // beyond that any may be set

} // namespace

void CallersLocals::Locals::add(Variable variable) {
    if (!any && std::ranges::find(some, variable) == some.end()) some.push_back(variable);
    any |= some.size() > most_locals;
}

void CallersLocals::Locals::add(const Locals& more) {
    any |= more.any;
    for (const Variable variable : more.some) add(variable);
}

CallersLocals::CallersLocals(const std::deque<ProgramAnalysis>& programs, const flow::Components& components,
                             const Asked& begins_vacant, const Asked& has_unknown_callers)
    : components_(components)
    , programs_(programs) {
    const auto is_given_locals = [&](const ProgramAnalysis& analysis) {
        return std::ranges::any_of(analysis.callers(), [&](const Caller& caller) { return shares(caller); });
    };
    if (std::ranges::none_of(programs, is_given_locals)) return;
    const std::size_t count = components.members.size();
    below_.resize(count);
    before_.resize(count);
    for (const ProgramAnalysis& analysis : programs) stored_.push_back(stored_in(analysis));
    for (std::uint32_t component = 0; component < count; ++component) {
        const auto members = components.members[component];
        if (members.size() == 1)
            below_[component] = stored_below(programs[members.front()]);
        else
            below_[component].any = true;
    }
    for (auto component = static_cast<std::uint32_t>(count); component-- > 0;) {
        const auto members = components.members[component];
        const ProgramAnalysis& analysis = programs[members.front()];
        Locals& before = before_[component];
        before.any = members.size() > 1 || has_unknown_callers(analysis) ||
                     (analysis.callers().empty() && !begins_vacant(analysis));
        std::optional<ProgramIndex> last; // calls of one program stand side by side
        for (const Caller& caller : analysis.callers()) {
            if (before.any) break;
            before.any = !shares(caller);
            if (last != caller.program) add_before(before, caller.program, analysis.index());
            last = caller.program;
        }
    }
}

std::optional<std::vector<Variable>> CallersLocals::set_before(const ProgramAnalysis& called) const {
    if (before_.empty()) return std::nullopt;
    const Locals& before = before_[components_.of[called.index()]];
    if (before.any) return std::nullopt;
    return before.some;
}

bool CallersLocals::shares(const Caller& caller) const {
    const Program& program = programs_[caller.program].program();
    const auto& call = std::get<Call>(program.effects[caller.effect].what);
    return program.control->calls[call.kind].frame == Frame::shared;
}

/// The variables that the program's own blocks may set.
CallersLocals::Locals CallersLocals::stored_in(const ProgramAnalysis& analysis) {
    Locals locals;
    const Program& program = analysis.program();
    dataflow::IndexReaches reaches(program, analysis.graph());
    const auto is_local = [&](Variable variable) {
        return program.control->spaces[variable.space].scope == Scope::frame;
    };
    for_each_effect(program, [&](EffectId id) {
        const auto& what = program.effects[id].what;
        if (const auto* assign = std::get_if<Assign>(&what)) {
            if (const auto* variable = std::get_if<Variable>(&assign->target);
                variable && is_local(*variable))
                locals.add(*variable);
            if (const auto* at = std::get_if<StoreAt>(&assign->target))
                locals.any |=
                    reaches.of(at->family, at->index, {}, analysis.graph().node_of(id).value_or(0)).locals;
        } else if (const auto* unreadable = std::get_if<UnreadableBlock>(&what)) {
            for (const Variable variable : program.variables_of(*unreadable)) locals.add(variable);
            locals.any |= unreadable->may_call_or_return;
        } else if (const auto* call = std::get_if<Call>(&what)) {
            locals.any |= std::ranges::any_of(program.arguments_of(*call), [](const Argument& argument) {
                return argument.passing != Passing::by_value;
            });
        }
    });
    return locals;
}

/// What the program stores, and those to which it hands its local variables.
CallersLocals::Locals CallersLocals::stored_below(const ProgramAnalysis& analysis) const {
    Locals locals = stored_[analysis.index()];
    for (const CallSite& site : analysis.calls()) {
        if (!shares({analysis.index(), site.effect})) continue;
        if (site.target && components_.of[*site.target] != components_.of[analysis.index()])
            locals.add(below_[components_.of[*site.target]]);
        else
            locals.any = true;
    }
    return locals;
}

/// Adds what the calling program may have set, itself or by other calls.
void CallersLocals::add_before(Locals& before, ProgramIndex caller, ProgramIndex called) const {
    const ProgramAnalysis& calling = programs_[caller];
    before.any |= calling.calls().size() > most_calls;
    if (before.any) return;
    before.add(before_[components_.of[caller]]);
    before.add(stored_[caller]);
    for (const CallSite& site : calling.calls()) {
        if (site.target == called || !shares({caller, site.effect})) continue;
        if (site.target)
            before.add(below_[components_.of[*site.target]]);
        else
            before.any = true;
    }
}

} // namespace maclint
