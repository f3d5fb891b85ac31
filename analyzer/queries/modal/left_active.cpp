//! Reads the states in which programs end and return.
#include "analyzer/queries/modal/left_active.hpp"

#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/queries/modal/modal_parts.hpp"
#include "analyzer/queries/modal/modes_at.hpp"
#include "analyzer/queries/paths/feasible_paths.hpp"
#include "analyzer/queries/values/origins.hpp"

#include <algorithm>

namespace maclint::queries {
namespace {

/// The last block of a fragment is not its end.
bool returns(const ProgramAnalysis& analysis, flow::ExitKind kind) {
    const bool called =
        analysis.program().started == Program::Started::by_call || !analysis.callers().empty();
    return kind == flow::ExitKind::returns || (kind == flow::ExitKind::runs_off && called);
}

bool ends(const ProgramAnalysis& analysis, flow::ExitKind kind) {
    return kind == flow::ExitKind::ends || kind == flow::ExitKind::restarts ||
           (kind == flow::ExitKind::runs_off && analysis.is_main());
}

/// Some program that calls this one ends or returns with what the call left on.
bool is_left_by_a_caller(const ProgramAnalysis& analysis, GroupId group) {
    return std::ranges::any_of(analysis.callers(), [&](const Caller& caller) {
        const ProgramAnalysis& calling = calling_program(analysis, caller);
        return std::ranges::any_of(
            calling.facts().all<dataflow::ExitState>(), [&](const dataflow::ExitState& exit) {
                const dataflow::ModalValue value = calling.data().modal(exit, group);
                return std::ranges::any_of(value.parts, [&](const dataflow::ModalPart& part) {
                    return effect_of_origin(calling, part.origin) == caller.effect;
                });
            });
    });
}

} // namespace

std::optional<GroupId> find_own_group(const ControlModel& control, ModalRole role) {
    const std::optional<GroupId> group = control.group_with(role);
    const bool own = group && control.groups[*group].restore_policy == RestorePolicy::own_rule;
    return own ? group : std::nullopt;
}

bool Lasting::until(flow::NodeId node, GroupId group, flow::NodeId set) {
    if (set == node) return true;
    const flow::Graph& graph = analysis_.graph();
    const auto channels =
        static_cast<Channels>(graph.channels_at(set).running & graph.channels_at(node).running);
    return can_follow(analysis_, set, node, setting(group, channels));
}

const std::vector<flow::NodeId>& Lasting::setting(GroupId group, Channels channels) {
    const auto [known, fresh] = setting_.try_emplace({group, channels});
    if (!fresh) return known->second;
    const flow::Graph& graph = analysis_.graph();
    for (flow::NodeId node = 0; node < graph.nodes.size(); ++node) {
        // What sets the group for other channels leaves it alone for these.
        const unsigned others = ~unsigned{graph.channels_at(node).running};
        if ((channels & others) == 0 && last_setting_in(analysis_, node, group))
            known->second.push_back(node);
    }
    return known->second;
}

namespace {

/// Of a program in one channel find_modal_leaks asks for a path.
bool lasts_in_its_channels(const ProgramAnalysis& analysis, Lasting& lasting, const dataflow::ExitState& exit,
                           GroupId group, const dataflow::ModalPart& part) {
    return !analysis.program().has_several_channels() ||
           lasting.until(exit.exit.node, group, node_of_origin(analysis, part.origin));
}

} // namespace

std::vector<ModalLeak> left_at_return(const ProgramAnalysis& analysis) {
    if (analysis.is_main()) return {};
    Lasting lasting(analysis);
    return find_modal_leaks(
        analysis, RestorePolicy::own_rule,
        [&](const ModalGroup& group, GroupId id, const dataflow::ExitState& exit, const auto& part) {
            return group.cancel && returns(analysis, exit.exit.kind) &&
                   is_switched_on(analysis, group, part) &&
                   lasts_in_its_channels(analysis, lasting, exit, id, part) &&
                   (!group.for_callers || is_left_by_a_caller(analysis, id));
        });
}

std::optional<ModalLeak> left_at_end(const ProgramAnalysis& analysis, ModalRole role) {
    Lasting lasting(analysis);
    const auto leaks = find_modal_leaks(
        analysis, RestorePolicy::own_rule,
        [&](const ModalGroup& group, GroupId id, const dataflow::ExitState& exit, const auto& part) {
            return group.role == role && group.cancel && ends(analysis, exit.exit.kind) &&
                   is_switched_on(analysis, group, part) &&
                   lasts_in_its_channels(analysis, lasting, exit, id, part);
        });
    if (leaks.empty()) return std::nullopt;
    return leaks.front();
}

} // namespace maclint::queries
