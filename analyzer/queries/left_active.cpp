//! Reads the states in which programs end and return.
#include "analyzer/queries/left_active.hpp"

#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/dataflow/facts/modal_write.hpp"
#include "analyzer/queries/callers.hpp"
#include "analyzer/queries/feasible_paths.hpp"
#include "analyzer/queries/modal_parts.hpp"
#include "analyzer/queries/origins.hpp"

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

bool lasts_until(const ProgramAnalysis& analysis, GroupId group, const dataflow::ModalPart& part,
                 flow::NodeId node) {
    const flow::NodeId set = node_of_origin(analysis, part.origin);
    if (set == node) return true;
    // What sets the group for other channels leaves it alone for these.
    const auto running = [&](flow::NodeId at) { return analysis.graph().channels_at(at).running; };
    const unsigned channels = running(set) & running(node);
    std::vector<flow::NodeId> setting; // sorted, as facts are
    for (const dataflow::ModalWrite& write : analysis.facts().all<dataflow::ModalWrite>())
        if (write.group == group && (channels & ~running(write.node)) == 0) setting.push_back(write.node);
    return can_follow(analysis, set, node, setting);
}

std::vector<ModalLeak> left_at_return(const ProgramAnalysis& analysis) {
    if (analysis.is_main()) return {};
    return find_modal_leaks(
        analysis, RestorePolicy::own_rule,
        [&](const ModalGroup& group, GroupId id, const dataflow::ExitState& exit, const auto& part) {
            return group.cancel && returns(analysis, exit.exit.kind) &&
                   is_switched_on(analysis, group, part) && lasts_until(analysis, id, part, exit.exit.node) &&
                   (!group.for_callers || is_left_by_a_caller(analysis, id));
        });
}

std::optional<ModalLeak> left_at_end(const ProgramAnalysis& analysis, ModalRole role) {
    const auto leaks = find_modal_leaks(
        analysis, RestorePolicy::own_rule,
        [&](const ModalGroup& group, GroupId id, const dataflow::ExitState& exit, const auto& part) {
            return group.role == role && group.cancel && ends(analysis, exit.exit.kind) &&
                   is_switched_on(analysis, group, part) && lasts_until(analysis, id, part, exit.exit.node);
        });
    if (leaks.empty()) return std::nullopt;
    return leaks.front();
}

} // namespace maclint::queries
