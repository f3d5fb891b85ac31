//! A search over the graphs of the callers: from each call on, until a block sets the group or moves under
//! it.
#include "analyzer/queries/leak_use.hpp"

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/overloaded.hpp"
#include "analyzer/queries/feasible_paths.hpp"
#include "analyzer/workspace/workspace.hpp"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

namespace maclint::queries {
namespace {

/// So many nodes are looked at; what lies beyond may rely on the state.
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
};

class Search {
  public:
    Search(const ProgramAnalysis& callee, GroupId group)
        : workspace_(callee.workspace())
        , control_(callee.control())
        , group_(group) {
        for (const Idle& idle : control_.idle)
            if (idle.value == group) idle_.push_back(idle.under);
        return_to_callers(callee);
    }

    LeakUse run() {
        while (!(stack_.empty() && waiting_.empty()) && !result_.matters) {
            if (!waiting_.empty() && stack_.size() == waiting_.back().earlier) {
                ask_caller();
                continue;
            }
            const Point point = stack_.back();
            stack_.pop_back();
            if (visited_.size() > most_visits) return {true, nullptr, {}};
            visit(point);
        }
        return result_;
    }

  private:
    [[nodiscard]] const ProgramAnalysis& at(ProgramIndex index) const { return workspace_.programs()[index]; }

    void push(const Point& point) {
        // Two calls that lead to one node are two questions: the path from each may be open or closed.
        const Visit key{point.program, point.node,     point.first, point.call,
                        point.idle,    point.channels, point.inside};
        if (visited_.insert(key).second) stack_.push_back(point);
    }

    /// Every path back to the callers of a program is the same: they are asked once.
    void return_to_callers(const ProgramAnalysis& program) {
        if (!returned_.insert(program.index()).second) return;
        std::vector<Caller> callers =
            program.callers().empty() ? program.possible_callers() : program.callers();
        if (callers.empty())
            result_.matters |= !program.is_main();
        else
            waiting_.push_back({std::move(callers), idle_after(program, 0), stack_.size()});
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
        for (const flow::Exit& exit : program.graph().exits)
            if (exit.node == point.node &&
                (exit.kind == flow::ExitKind::returns || exit.kind == flow::ExitKind::runs_off))
                return_to_callers(program);
    }

    /// Whether the group is as it was after the run, and nobody has moved under it.
    bool visit_run(const ProgramAnalysis& program, const flow::Node& node, Point& point) {
        bool goes_on = true;
        for_each_block(program.program(), node.stretch(), [&](const BlockView& block) {
            for (const ModalSetting& setting : block.settings) {
                goes_on &= setting.group != group_;
                note_code(setting.group, setting.value, point);
            }
            if (goes_on && block.moves) goes_on = passes_move(program, block.span, point, false);
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
                               [&](const SetModal& set) { return passes_setting(program, set, point); },
                               [&](const Motion& motion) {
                                   return passes_move(program, node.part, point, motion.without_feed);
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

    /// A word without a group may be the one that sets it.
    bool passes_setting(const ProgramAnalysis& program, const SetModal& set, Point& point) const {
        if (!set.group) return control_.groups[group_].letter != set.letter;
        if (*set.group == group_) return false;
        const auto* code = std::get_if<Literal>(&program.program().expressions[set.value].node);
        note_code(*set.group, code == nullptr ? std::nullopt : std::optional(code->value), point);
        return true;
    }

    void note_code(GroupId group, std::optional<double> code, Point& point) const {
        for (std::size_t i = 0; i < idle_.size(); ++i)
            if (idle_[i].group == group)
                point.idle = code == idle_[i].code ? point.idle | 1U << i : point.idle & ~(1U << i);
    }

    /// A move for which the value is idle, or to which no path leads from the call, does not count.
    bool passes_move(const ProgramAnalysis& program, Span block, const Point& point, bool without_feed) {
        if (!idle_.empty() && (point.idle != 0 || without_feed)) return true;
        if (!point.inside && !can_follow(program, point.call, point.node)) return true;
        result_ = {true, &program, block};
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
                if (change.group != idle_[i].group) continue;
                const bool sure =
                    !change.may_keep && !change.other &&
                    std::ranges::all_of(change.codes, [&](double code) { return code == idle_[i].code; });
                idle = sure ? idle | 1U << i : idle & ~(1U << i);
            }
        return idle;
    }

    const Workspace& workspace_;
    const ControlModel& control_;
    GroupId group_;
    std::vector<GroupCode> idle_; ///< codes under which no move asks for the value
    std::vector<Point> stack_;
    /// Callers to which a program returns, each looked at when the one before leaves nothing to look at.
    struct Returning {
        std::vector<Caller> callers;
        std::uint32_t idle;
        std::size_t earlier; ///< so many points were there before, and come later
    };
    std::vector<Returning> waiting_;
    std::set<ProgramIndex> returned_;
    using Visit =
        std::tuple<ProgramIndex, flow::NodeId, EffectId, flow::NodeId, std::uint32_t, Channels, bool>;
    std::set<Visit> visited_;
    LeakUse result_{false, nullptr, {}};
};

} // namespace

LeakUse leak_use_of(const ProgramAnalysis& callee, GroupId group) { return Search(callee, group).run(); }

} // namespace maclint::queries
