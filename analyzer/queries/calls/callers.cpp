//! Looks through the calls of a workspace that mean one program.
#include "analyzer/queries/calls/callers.hpp"

#include "analyzer/program/tables.hpp"
#include "analyzer/source/budget.hpp"

#include <algorithm>
#include <string_view>
#include <utility>
#include <variant>

namespace maclint::queries {
namespace {

/// With its last slash; empty for a file without a folder.
std::string_view folder_of(const ProgramAnalysis& analysis) {
    const std::string_view path = analysis.source()->path();
    return path.substr(0, path.rfind('/') + 1);
}

/// The first of the program's callers with that property.
template<class Property>
const Caller* find_caller(const ProgramAnalysis& analysis, const Property& property) {
    for (const Caller& caller : analysis.callers()) {
        if (!Budget::allows()) return nullptr;
        if (property(caller)) return &caller;
    }
    return nullptr;
}

} // namespace

const ProgramAnalysis& calling_program(const ProgramAnalysis& analysis, const Caller& caller) {
    return analysis.workspace().programs()[caller.program];
}

const ProgramAnalysis* called_program(const ProgramAnalysis& analysis, const CallSite& site) {
    return site.target ? &analysis.workspace().programs()[*site.target] : nullptr;
}

bool call_may_change(const ProgramAnalysis& analysis, EffectId call, GroupId group) {
    if (const GivenWord* word = analysis.word_at(call))
        return std::ranges::find(word->sets, group, &std::pair<GroupId, double>::first) != word->sets.end();
    const CallSite* site = analysis.call_at(call);
    const ProgramAnalysis* callee = site == nullptr ? nullptr : called_program(analysis, *site);
    return callee == nullptr ||
           std::ranges::find(callee->summary().groups, group, &dataflow::GroupChange::group) !=
               callee->summary().groups.end();
}

const Call& call_of(const Program& program, EffectId effect) {
    return std::get<Call>(program.effects[effect].what);
}

const Argument* argument_for(const ProgramAnalysis& analysis, const Caller& caller, Variable formal) {
    const decltype(Argument::given) given = formal;
    const Program& program = calling_program(analysis, caller).program();
    const auto arguments = program.arguments_of(call_of(program, caller.effect));
    const auto found = std::ranges::find(arguments, given, &Argument::given);
    return found == arguments.end() ? nullptr : &*found;
}

bool opens_locals(const ProgramAnalysis& analysis, const Caller& caller) {
    const ProgramAnalysis& calling = calling_program(analysis, caller);
    return calling.control().calls[call_of(calling.program(), caller.effect).kind].frame == Frame::fresh;
}

bool is_of_one_control(const ProgramAnalysis& analysis, const Caller& caller) {
    const std::string_view own = folder_of(analysis), its = folder_of(calling_program(analysis, caller));
    const bool is_for_calls = analysis.program().started != Program::Started::by_hand;
    return (analysis.complete() && is_for_calls) || own.starts_with(its) || its.starts_with(own);
}

const Caller* find_reached_caller(const ProgramAnalysis& analysis) {
    return find_caller(analysis, [&](const Caller& caller) {
        const ProgramAnalysis& calling = calling_program(analysis, caller);
        const auto node = calling.graph().node_of(caller.effect);
        return caller.program != analysis.index() && is_of_one_control(analysis, caller) && node &&
               calling.data().reached(*node);
    });
}

const Caller* find_caller_without(const ProgramAnalysis& analysis, Variable formal,
                                  const std::function<bool(const Caller&)>& also) {
    return find_caller(analysis, [&](const Caller& caller) {
        return argument_for(analysis, caller, formal) == nullptr && (!also || also(caller));
    });
}

std::vector<const Caller*> first_callers(const ProgramAnalysis& analysis) {
    std::vector<const Caller*> first; // calls of one program stand side by side
    for (const Caller& caller : analysis.callers())
        if (first.empty() || first.back()->program != caller.program) first.push_back(&caller);
    return first;
}

const Caller* find_caller_lacking(const ProgramAnalysis& analysis, std::span<const Caller* const> callers,
                                  std::int64_t block_number) {
    const auto found = std::ranges::find_if(callers, [&](const Caller* caller) {
        const ProgramAnalysis& calling = calling_program(analysis, *caller);
        return !calling.is_recursive() && !calling.graph().has_label(block_number);
    });
    return found == callers.end() ? nullptr : *found;
}

bool knows_callers(const ProgramAnalysis& analysis) {
    return !analysis.callers().empty() || analysis.has_possible_callers();
}

KnownCallers known_or_possible_callers(const ProgramAnalysis& analysis) {
    if (!analysis.callers().empty()) return {analysis.callers(), true};
    PossibleCallers possible = analysis.possible_callers();
    return {std::move(possible.first), possible.all};
}

bool is_called_by_nobody(const ProgramAnalysis& analysis) {
    return analysis.complete() && !knows_callers(analysis);
}

} // namespace maclint::queries
