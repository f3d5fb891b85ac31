//! A search over the graphs of the callers: from each call on, until a block sets the group or moves under
//! it.
#include "analyzer/queries/modal/leak_use.hpp"

#include "analyzer/dataflow/domain/interner.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/overloaded.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/queries/modal/modal_parts.hpp"
#include "analyzer/queries/modal/own_settings.hpp"
#include "analyzer/queries/modal/saved_state.hpp"
#include "analyzer/queries/paths/feasible_paths.hpp"
#include "analyzer/workspace/workspace.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <variant>
#include <vector>

namespace maclint::queries {
namespace {

/// Nodes that are looked at; what lies beyond them may rely on the state.
constexpr std::size_t most_visits = 20'000;

/// What is known on the path to a node.
struct Point {
    ProgramIndex program;
    flow::NodeId node;
    EffectId first;     ///< effects of the node before this one have run
    flow::NodeId call;  ///< the node that made the call, where the search began in this program
    std::uint32_t idle; ///< bit n: the n-th code under which nobody asks for the value is in force
    Channels channels;  ///< in which the group was left so; 0: all that run the program
    bool inside; ///< of a program that was called on the path: its return leads back to where we are anyway
    friend bool operator==(const Point&, const Point&) = default;
};

std::uint64_t hash_mixed(const Point& point) {
    std::uint64_t hash = dataflow::side_by_side(point.program, point.node);
    hash = dataflow::mix(hash, dataflow::side_by_side(point.first, point.call));
    return dataflow::mix(hash, dataflow::side_by_side(point.idle, point.channels) ^
                                   (std::uint64_t{point.inside} << 63U));
}
std::uint64_t hash_local(const Point& point) { return hash_mixed(point); }

class FirstUseOfLeak {
  public:
    FirstUseOfLeak(const ProgramAnalysis& callee, GroupId group, const dataflow::ExitState& exit,
                   flow::NodeId set)
        : workspace_(callee.workspace())
        , control_(callee.control())
        , callee_(callee)
        , group_(group)
        , left_(callee.data().modal(exit, group)) {
        for (const Idle& idle : control_.idle)
            if (idle.value == group) idle_.push_back(idle);
        return_to_callers(callee, idle_at(exit, set));
    }

    LeakUse run() {
        while (!(stack_.empty() && waiting_.empty()) && !is_settled()) {
            if (!waiting_.empty() && stack_.size() == waiting_.back().earlier) {
                ask_caller();
                continue;
            }
            const Point point = stack_.back();
            stack_.pop_back();
            if (met_ > most_visits) {
                result_.matters = true;
                break;
            }
            visit(point);
        }
        if (!result_.matters && !all_callers_asked_) callee_.search_memory().count(true);
        return result_;
    }

  private:
    [[nodiscard]] const ProgramAnalysis& at(ProgramIndex index) const { return workspace_.programs()[index]; }

    [[nodiscard]] bool is_motion() const { return control_.groups[group_].role == ModalRole::motion; }
    [[nodiscard]] bool is_value() const {
        return control_.groups[group_].restore_policy == RestorePolicy::value;
    }

    [[nodiscard]] bool is_offset() const {
        return control_.groups[group_].restore_policy == RestorePolicy::offset;
    }

    /// Of values, offsets and the motion mode the caller is looked for that loses its own.
    [[nodiscard]] bool is_settled() const {
        const bool asks_for_own = is_value() || is_motion() || is_offset();
        return result_.matters && (!asks_for_own || result_.own_is_lost || result_.gives_feed);
    }

    void push(const Point& point) {
        // Two calls that lead to one node are two questions: the path from each may be open or closed.
        if (points_(point) != met_) return;
        ++met_;
        stack_.push_back(point);
    }

    /// Of paths back to the callers of a program those with the same codes in force are the same: the callers
    /// are asked once.
    void return_to_callers(const ProgramAnalysis& program, std::uint32_t idle) {
        if (!returned_.emplace(program.index(), idle).second) return;
        // A program that keeps its callers' state answers for this value, too.
        if (is_value() && &program != &callee_ && keeps_callers_state(program)) return;
        auto [callers, all] = known_or_possible_callers(program);
        all_callers_asked_ &= all;
        if (callers.empty())
            result_.matters |= !program.is_main() && !is_given_again(idle);
        else
            waiting_.push_back({std::move(callers), idle, stack_.size()});
    }

    /// Whether it is a custom to give the value again when one of the codes in force ends.
    [[nodiscard]] bool is_given_again(std::uint32_t idle) const {
        for (std::size_t i = 0; i < idle_.size(); ++i)
            if ((idle >> i & 1U) != 0 && idle_[i].given_again) return exemptions::speed_given_again.is_on();
        return false;
    }

    /// Which of the codes are in force there on the paths over `set`.
    [[nodiscard]] std::uint32_t idle_at(const dataflow::ExitState& exit, flow::NodeId set) const {
        std::uint32_t idle = 0;
        for (std::size_t i = 0; i < idle_.size(); ++i) {
            const dataflow::ModalValue value = callee_.data().modal(exit, idle_[i].under.group);
            const bool sure = !value.unknown && !value.parts.empty() &&
                              std::ranges::all_of(value.parts, [&](const dataflow::ModalPart& part) {
                                  return code_of(callee_, part) == idle_[i].under.code;
                              });
            if (sure || stays_at(callee_, set, idle_[i].under) ||
                is_given_on_the_way(callee_, set, exit.exit.node, idle_[i].under))
                idle |= 1U << i;
        }
        return idle;
    }

    /// Whether the program set the group itself before the call, and to something else than is left: a value
    /// unless it is known to be the same, the motion mode and offsets where it is known to be another.
    [[nodiscard]] bool has_own(const ProgramAnalysis& program, flow::NodeId call) const {
        const bool is_code = is_motion() || is_offset();
        if (!is_value() && !is_code) return false;
        const auto settings = last_settings_before(program, call, group_);
        const auto is_left = [&](double setting) {
            return std::ranges::any_of(left_.parts, [&](const dataflow::ModalPart& part) {
                return code_of(callee_, part).value_or(is_code ? setting : setting + 1) == setting;
            });
        };
        return !settings.empty() && std::ranges::all_of(settings, [&](const std::optional<double>& setting) {
            return setting ? !is_left(*setting) : is_value();
        });
    }

    /// Whether what the program has set itself is in force at the call, on a path that can be taken.
    bool loses_own(const ProgramAnalysis& program, flow::NodeId call) {
        const auto [known, fresh] = loses_own_.try_emplace({program.index(), call}, false);
        if (fresh) known->second = has_own(program, call) && is_set_on_a_path_to(program, call, group_);
        return known->second;
    }

    /// Goes on after the call of the next caller.
    void ask_caller() {
        Returning& returning = waiting_.back();
        const Caller caller = returning.callers.back();
        const std::uint32_t idle = returning.idle;
        returning.callers.pop_back();
        if (returning.callers.empty()) waiting_.pop_back();
        const auto node = at(caller.program).graph().node_of(caller.effect);
        if (!node)
            result_.matters = true; // in a part that nothing executes
        else
            push({caller.program, *node, caller.effect + 1, *node, idle,
                  at(caller.program).graph().channels_at(*node).running, false});
    }

    void visit(Point point) {
        const ProgramAnalysis& program = at(point.program);
        const flow::Node& node = program.graph().nodes[point.node];
        const Channels running = program.graph().channels_at(point.node).running;
        const bool is_passed = point.channels != 0 && (running & point.channels) == 0;
        const bool goes_on = is_passed     ? true
                             : node.is_run ? visit_run(program, node, point)
                                           : visit_block(program, node, point);
        if (!goes_on) return;
        for (const flow::EdgeId id : program.graph().out[point.node])
            if (program.data().passable(id))
                push({point.program, program.graph().edges[id].to, 0, point.call, point.idle, point.channels,
                      point.inside});
        if (point.inside) return;
        for (const flow::Exit& exit : program.graph().exits_at(point.node))
            if (exit.kind == flow::ExitKind::returns || exit.kind == flow::ExitKind::runs_off)
                return_to_callers(program, point.idle);
    }

    /// Whether the group is as it was after the run, and nobody has moved under it.
    bool visit_run(const ProgramAnalysis& program, const flow::Node& node, Point& point) {
        bool goes_on = true;
        for_each_block(program.program(), node.stretch(), [&](const BlockView& block) {
            for (const BlockSetting& setting : block.settings) goes_on &= passes_setting(setting, point);
            if (goes_on && block.moves) goes_on = passes_move(program, {node.item, block.span}, point, false);
            return goes_on;
        });
        return goes_on;
    }

    bool visit_block(const ProgramAnalysis& program, const flow::Node& node, Point& point) {
        const EffectId end = node.effects.first + node.effects.count;
        for (EffectId id = std::max(point.first, node.effects.first); id < end; ++id) {
            const Effect& effect = program.program().effects[id];
            const bool goes_on =
                std::visit(overloaded{
                               [&](const SetModal& set) {
                                   // Without a group it may be the one that sets it.
                                   const auto setting = setting_of(program.program(), effect);
                                   return setting ? passes_setting(*setting, point)
                                                  : control_.groups[group_].letter != set.letter;
                               },
                               [&](const Motion& motion) {
                                   return passes_move(program, node.stretch(), point, motion.without_feed);
                               },
                               [&](const Call& call) { return passes_call(program, id, call, point); },
                               // What it does is not known: nothing is claimed after it.
                               [](const UnreadableBlock&) { return false; },
                               [](const auto&) { return true; },
                           },
                           effect.what);
            if (!goes_on) return false;
        }
        return true;
    }

    /// Whether the word leaves the group alone.
    bool passes_setting(const BlockSetting& setting, Point& point) const {
        for (std::size_t i = 0; i < idle_.size(); ++i)
            if (idle_[i].under.group == setting.group)
                point.idle =
                    setting.value == idle_[i].under.code ? point.idle | 1U << i : point.idle & ~(1U << i);
        return setting.group != group_;
    }

    /// A move for which the value is idle, or to which no path leads from the call, does not count.
    bool passes_move(const ProgramAnalysis& program, const Stretch& block, const Point& point,
                     bool without_feed) {
        if ((!idle_.empty() || is_motion()) && (point.idle != 0 || without_feed)) return true;
        const ModalMove move = is_motion() ? modal_move_in(program, block) : ModalMove{true, false};
        if (!move.relies) return true;
        if (!point.inside && !can_follow(program, point.call, point.node)) return true;
        const bool own_is_lost = !point.inside && loses_own(program, point.call);
        if (result_.program == nullptr || own_is_lost || move.gives_feed)
            result_ = {true, &program, block.span, own_is_lost, move.gives_feed};
        return false;
    }

    /// What the called program may set is not followed any further.
    bool passes_call(const ProgramAnalysis& program, EffectId id, const Call& call, Point& point) {
        if (program.control().calls[call.kind].trigger != CallTrigger::once) return true;
        const CallSite* site = program.call_at(id);
        if (site == nullptr || !site->target || site->in_cycle) return false;
        const ProgramAnalysis& callee = at(*site->target);
        push({callee.index(), 0, 0, 0, point.idle, 0, true});
        point.idle = idle_after(callee, point.idle);
        return std::ranges::find(callee.summary().groups, group_, &dataflow::GroupChange::group) ==
               callee.summary().groups.end();
    }

    /// Which of the codes are in force when the program has returned.
    [[nodiscard]] std::uint32_t idle_after(const ProgramAnalysis& program, std::uint32_t before) const {
        std::uint32_t idle = before;
        for (std::size_t i = 0; i < idle_.size(); ++i)
            for (const dataflow::GroupChange& change : program.summary().groups) {
                if (change.group != idle_[i].under.group) continue;
                const bool kept = !change.may_keep || (before >> i & 1U) != 0;
                const bool sure =
                    kept && !change.other && std::ranges::all_of(change.codes, [&](double code) {
                        return code == idle_[i].under.code;
                    });
                idle = sure ? idle | 1U << i : idle & ~(1U << i);
            }
        return idle;
    }

    const Workspace& workspace_;
    const ControlModel& control_;
    const ProgramAnalysis& callee_;
    GroupId group_;
    dataflow::ModalValue left_; ///< in the group
    std::vector<Idle> idle_;    ///< codes under which no move asks for the value
    std::vector<Point> stack_;
    /// Callers to which a program returns, each looked at when the one before leaves nothing to look at.
    struct Returning {
        std::vector<Caller> callers;
        std::uint32_t idle;
        std::size_t earlier; ///< points that were there before, and come later
    };
    std::vector<Returning> waiting_;
    std::set<std::pair<ProgramIndex, std::uint32_t>> returned_;
    dataflow::Interner<Point> points_; ///< met so far
    std::size_t met_ = 0;              ///< so many
    bool all_callers_asked_ = true;
    std::map<std::pair<ProgramIndex, flow::NodeId>, bool> loses_own_; ///< by program and call
    LeakUse result_;
};

} // namespace

LeakUse leak_use_of(const ProgramAnalysis& callee, GroupId group, const dataflow::ExitState& exit,
                    flow::NodeId set) {
    return FirstUseOfLeak(callee, group, exit, set).run();
}

} // namespace maclint::queries
