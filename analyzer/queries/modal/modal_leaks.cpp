//! Reads the states in which a program is left.
#include "analyzer/queries/modal/modal_leaks.hpp"

#include "analyzer/dataflow/facts/call_made.hpp"
#include "analyzer/dataflow/facts/modal_write.hpp"
#include "analyzer/execution/path_search.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/queries/modal/handed_modes.hpp"
#include "analyzer/queries/modal/modal_parts.hpp"
#include "analyzer/queries/modal/modes_at.hpp"
#include "analyzer/queries/modal/own_settings.hpp"
#include "analyzer/queries/modal/saved_state.hpp"
#include "analyzer/queries/values/origins.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <variant>

namespace maclint::queries {
namespace {

/// A word whose block gives it another meaning: `M19 S90.` need not set a speed.
bool may_mean_something_else(const ProgramAnalysis& analysis, GroupId group, dataflow::OriginId set) {
    return exemptions::angle_of_the_spindle.is_on() &&
           std::ranges::any_of(analysis.control().idle, [&](const Idle& idle) {
               return idle.value == group && idle.other_meaning && stands_beside(analysis, set, idle.under);
           });
}

/// Whether the value of a word decides what it sets, and it may be the group.
bool decides_itself(const ProgramAnalysis& analysis, const dataflow::ModalWrite& write, GroupId group) {
    if (write.group) return *write.group == group;
    const auto* set = std::get_if<SetModal>(&analysis.program().effects[write.effect].what);
    return set == nullptr || set->letter == analysis.control().groups[group].letter;
}

enum class Change : std::uint8_t { sure, possible };

/// Whether the call changes the group, or may.
bool changes_group(const ProgramAnalysis& analysis, const dataflow::CallMade& made, GroupId group,
                   Change wanted) {
    const CallSite* site = analysis.call_at(made.effect);
    const ProgramAnalysis* callee = site == nullptr ? nullptr : called_program(analysis, *site);
    if (!made.known || callee == nullptr) return wanted == Change::possible;
    const auto& changes = callee->summary().groups;
    const auto change = std::ranges::find(changes, group, &dataflow::GroupChange::group);
    if (change == changes.end() || wanted == Change::possible) return change != changes.end();
    const auto* call = std::get_if<Call>(&analysis.program().effects[made.effect].what);
    return call != nullptr && !change->may_keep && flow::surely_runs(analysis.program(), *call) &&
           analysis.control().calls[call->kind].trigger == CallTrigger::once;
}

/// The nodes after which the group is something else, or may be, sorted: words that set it and calls.
std::vector<flow::NodeId> changes_of(const ProgramAnalysis& analysis, GroupId group, Change wanted) {
    const flow::Graph& graph = analysis.graph();
    std::vector<flow::NodeId> nodes;
    for (flow::NodeId node = 0; node < graph.nodes.size(); ++node)
        if (const auto setting = last_setting_in(analysis, node, group);
            setting && (wanted == Change::possible || setting->value)) // one that is vacant is ignored
            nodes.push_back(node);
    for (const dataflow::ModalWrite& write : analysis.facts().all<dataflow::ModalWrite>())
        if (wanted == Change::possible && decides_itself(analysis, write, group)) nodes.push_back(write.node);
    for (const dataflow::CallMade& call : analysis.facts().all<dataflow::CallMade>())
        if (changes_group(analysis, call, group, wanted)) nodes.push_back(call.node);
    std::ranges::sort(nodes);
    return nodes;
}

/// Looks at the exits for what of one group is left.
class LeftState {
  public:
    LeftState(const ProgramAnalysis& analysis, GroupId group, const IsFault& is_fault,
              std::optional<KeptState> kept)
        : analysis_(analysis)
        , group_(group)
        , is_fault_(is_fault)
        , kept_(kept)
        , is_value_(analysis.control().groups[group].restore_policy == RestorePolicy::value)
        , answers_for_calls_(is_value_ && keeps_callers_state(analysis)) {}

    std::optional<ModalLeak> run() {
        for (const dataflow::ExitState& exit : analysis_.facts().all<dataflow::ExitState>())
            if (exit.exit.kind != flow::ExitKind::alarm) look_at(exit);
        if (!last_) return std::nullopt;
        last_->on_every_path = !elsewhere_right_;
        last_->kept = kept_;
        if (kept_) return last_;
        if (last_->exit->exit.kind == flow::ExitKind::returns)
            last_->leak_use =
                leak_use_of(analysis_, group_, *last_->exit, node_of_origin(analysis_, last_->part.origin));
        return last_->leak_use.matters && !is_for_callers() ? last_ : std::nullopt;
    }

  private:
    /// What acts on later moves may be switched on for the callers, who are to switch it off: on the way to a
    /// contour, for a cycle's positions. And some programs are there for nothing else.
    [[nodiscard]] bool is_for_callers() const {
        const ModalGroup& group = analysis_.control().groups[group_];
        if (last_->exit->exit.kind != flow::ExitKind::returns ||
            group.restore_policy == RestorePolicy::modal_call)
            return false;
        const bool asks_callers = group.cancel && knows_callers(analysis_);
        return asks_callers ? exemptions::callers_cancel.is_on() && callers_cancel(analysis_, group_)
                            : exemptions::only_sets_modes.is_on() && last_->on_every_path &&
                                  only_sets_modes(analysis_.program());
    }

    void look_at(const dataflow::ExitState& exit) {
        const dataflow::ModalValue value = analysis_.data().modal(exit, group_);
        elsewhere_right_ |= value.unknown;
        for (const dataflow::ModalPart& part : value.parts) {
            // A path on which nothing sets the group, as when a word is ignored, puts nothing back. What a
            // called program left is that program's, unless this one keeps what its callers had.
            if (part.origin == 0 || (is_made_by_call(analysis_, part.origin) && !answers_for_calls_) ||
                may_mean_something_else(analysis_, group_, part.origin))
                continue;
            const bool fault = is_fault_(analysis_.control().groups[group_], group_, exit, part) ||
                               is_not_put_back(exit, part);
            elsewhere_right_ |= !fault;
            const bool is_all = value.parts.size() == 1 && !value.unknown;
            if (fault && comes_later(part) && (is_all || lasts(part, exit, value.unknown)))
                last_ = ModalLeak{group_, part, &exit, true, {.matters = true}, {}};
        }
    }

    /// What the program keeps of its callers' and puts back at no return, or not at this one.
    [[nodiscard]] bool is_not_put_back(const dataflow::ExitState& exit,
                                       const dataflow::ModalPart& part) const {
        return kept_ && exit.exit.kind == flow::ExitKind::returns &&
               !may_be_callers(analysis_, group_, part) && source_of(analysis_, part) != NumberSource::other;
    }

    /// Words of the program itself come before calls, then the last in the text.
    [[nodiscard]] bool comes_later(const dataflow::ModalPart& part) const {
        if (!last_) return true;
        const auto place = [&](const dataflow::ModalPart& of) {
            return std::pair(!is_made_by_call(analysis_, of.origin),
                             span_of_origin(analysis_, of.origin).begin);
        };
        return place(last_->part) < place(part);
    }

    /// Whether a path leads from there to the exit on which nothing changes the group. Where something
    /// unknown may have changed it, the path must lead around that, too, a search that gives up tells
    /// nothing, and of a feed or speed that is asked only where the program keeps its callers' state.
    [[nodiscard]] bool lasts(const dataflow::ModalPart& part, const dataflow::ExitState& exit,
                             bool may_be_changed) {
        if (analysis_.program().has_several_channels()) return !may_be_changed;
        if (may_be_changed && is_value_ && !answers_for_calls_) return false;
        const auto& changes = changes_around(may_be_changed ? Change::possible : Change::sure);
        const flow::NodeId set = node_of_origin(analysis_, part.origin);
        const flow::NodeId end = exit.exit.node;
        if (set != end && std::ranges::binary_search(changes, end)) return !may_be_changed;
        const auto found = execution::PathSearch(analysis_).find(
            std::array{execution::Leg{set, {}}, execution::Leg{end, changes}});
        return found.path || (!may_be_changed && (found.gave_up || found.may_miss));
    }

    const std::vector<flow::NodeId>& changes_around(Change wanted) {
        auto& changes = wanted == Change::sure ? sure_changes_ : possible_changes_;
        if (!changes) changes = changes_of(analysis_, group_, wanted);
        return *changes;
    }

    const ProgramAnalysis& analysis_;
    GroupId group_;
    const IsFault& is_fault_;
    std::optional<KeptState> kept_;
    bool is_value_, answers_for_calls_;
    std::optional<std::vector<flow::NodeId>> sure_changes_, possible_changes_;
    std::optional<ModalLeak> last_;
    bool elsewhere_right_ = false;
};

/// A jump of which it is unknown whether it is taken, such as M97 P10: to blocks that run as a subprogram of
/// this program. A return then need not leave it.
bool may_return_within(const Program& program) {
    return std::ranges::any_of(program.effects, [&](const Effect& effect) {
        const auto* guarded = std::get_if<Guarded>(&effect.what);
        return guarded != nullptr &&
               std::holds_alternative<Unreadable>(program.expressions[guarded->condition].node);
    });
}

} // namespace

std::vector<ModalLeak> find_modal_leaks(const ProgramAnalysis& analysis, RestorePolicy restore_policy,
                                        const IsFault& is_fault) {
    std::vector<ModalLeak> leaks;
    const auto& groups = analysis.control().groups;
    const auto all_kept = can_be_kept(restore_policy) ? find_kept_states(analysis) : std::vector<KeptState>{};
    for (std::size_t group = 0; group < groups.size(); ++group) {
        if (groups[group].restore_policy != restore_policy) continue;
        const auto known = std::ranges::find(all_kept, static_cast<GroupId>(group), &KeptState::group);
        const auto kept = known == all_kept.end() ? std::nullopt : std::optional(*known);
        if (const auto leak = LeftState(analysis, static_cast<GroupId>(group), is_fault, kept).run())
            leaks.push_back(*leak);
    }
    if (exemptions::returns_within.is_on() && !leaks.empty() && may_return_within(analysis.program()))
        leaks.clear();
    return leaks;
}

} // namespace maclint::queries
