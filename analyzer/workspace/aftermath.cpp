//! A search over the graphs of the callers: from each call on, until a block sets the group or moves under
//! it.
#include "analyzer/workspace/aftermath.hpp"

#include "analyzer/program/overloaded.hpp"
#include "analyzer/workspace/workspace.hpp"

#include <algorithm>
#include <unordered_set>
#include <variant>
#include <vector>

namespace maclint {
namespace {

/// So many nodes are looked at; what lies beyond may rely on the state.
constexpr std::size_t most_visits = 20'000;

/// What is known on the way to a node.
struct Point {
    ProgramIndex program;
    flow::NodeId node;
    EffectId first; ///< effects of the node before this one have run
    bool rapid;     ///< moves ignore the feed
    bool inside;    ///< of a program that was called on the way: its return leads back to where we are anyway
};

class Search {
  public:
    Search(const ProgramAnalysis& callee, GroupId group)
        : workspace_(callee.workspace())
        , control_(callee.control())
        , group_(group)
        , about_value_(control_.groups[group].concern == Concern::value) {
        return_to_callers(callee);
    }

    Aftermath run() {
        while (!stack_.empty() && !result_.matters) {
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
        const std::uint64_t key = std::uint64_t{point.program} << 34U | std::uint64_t{point.node} << 2U |
                                  (point.rapid ? 2U : 0U) | (point.inside ? 1U : 0U);
        if (point.first != 0 || visited_.insert(key).second) stack_.push_back(point);
    }

    void return_to_callers(const ProgramAnalysis& program) {
        if (program.callers().empty()) {
            result_.matters |= !program.is_main();
            return;
        }
        for (const Caller& caller : program.callers()) {
            const flow::Graph& graph = at(caller.program).graph();
            const auto node = std::ranges::find_if(graph.nodes, [&](const flow::Node& n) {
                return n.effects.first <= caller.effect && caller.effect < n.effects.first + n.effects.count;
            });
            if (node == graph.nodes.end()) {
                result_.matters = true; // called under a condition of its own
                return;
            }
            push({caller.program, static_cast<flow::NodeId>(node - graph.nodes.begin()), caller.effect + 1,
                  leaves_rapid(program), false});
        }
    }

    void visit(Point point) {
        const ProgramAnalysis& program = at(point.program);
        const flow::Node& node = program.graph().nodes[point.node];
        const bool goes_on =
            node.is_run ? visit_run(program, node, point.rapid) : visit_block(program, node, point);
        if (!goes_on) return;
        for (const flow::EdgeId id : program.graph().out[point.node])
            if (program.data().passable(id))
                push({point.program, program.graph().edges[id].to, 0, point.rapid, point.inside});
        if (point.inside) return;
        for (const flow::Exit& exit : program.graph().exits)
            if (exit.node == point.node &&
                (exit.kind == flow::ExitKind::returns || exit.kind == flow::ExitKind::runs_off))
                return_to_callers(program);
    }

    /// Whether the group is as it was behind the run, and nobody has moved under it.
    bool visit_run(const ProgramAnalysis& program, const flow::Node& node, bool& rapid) {
        bool set = false;
        program.program().for_each_block(node.part, [&](const PlainBlock& block) {
            for (const ModalSetting& setting : block.settings) {
                set |= setting.group == group_;
                note_motion_mode(setting.group, setting.value, rapid);
            }
            if (!set && block.moves) note_move(program, block.span, rapid);
            return !set && !result_.matters;
        });
        return !set && !result_.matters;
    }

    bool visit_block(const ProgramAnalysis& program, const flow::Node& node, Point& point) {
        const EffectId end = node.effects.first + node.effects.count;
        for (EffectId id = std::max(point.first, node.effects.first); id < end; ++id) {
            const Effect& effect = program.program().effects[id];
            const bool goes_on =
                std::visit(overloaded{
                               [&](const SetModal& set) { return note_setting(program, set, point.rapid); },
                               [&](const Motion& motion) {
                                   note_move(program, node.part, point.rapid || motion.without_feed);
                                   return !result_.matters;
                               },
                               [&](const Call& call) { return note_call(program, id, call, point); },
                               // What it does is not known: nothing is claimed behind it.
                               [](const UnreadableBlock&) { return false; },
                               [](const auto&) { return true; },
                           },
                           effect.what);
            if (!goes_on) return false;
        }
        return true;
    }

    /// A word without a group may be the one that sets it.
    bool note_setting(const ProgramAnalysis& program, const SetModal& set, bool& rapid) const {
        if (!set.group) return control_.groups[group_].letter != set.letter;
        if (*set.group == group_) return false;
        const auto* code = std::get_if<Literal>(&program.program().expressions[set.value].node);
        if (code != nullptr)
            note_motion_mode(*set.group, code->value, rapid);
        else if (control_.rapid && *set.group == control_.rapid->group)
            rapid = false;
        return true;
    }

    void note_motion_mode(GroupId group, double code, bool& rapid) const {
        if (control_.rapid && group == control_.rapid->group) rapid = code == control_.rapid->code;
    }

    void note_move(const ProgramAnalysis& program, Span block, bool rapid) {
        if (!result_.matters && !(about_value_ && rapid)) result_ = {true, &program, block};
    }

    bool note_call(const ProgramAnalysis& program, EffectId id, const Call& call, Point& point) {
        if (program.control().calls[call.kind].when != When::once) return true;
        const CallSite* site = program.call_at(id);
        if (site == nullptr || !site->target || site->in_cycle) return false;
        const ProgramAnalysis& callee = at(*site->target);
        push({callee.index(), 0, 0, point.rapid, true});
        point.rapid = leaves_rapid(callee);
        return std::ranges::none_of(callee.summary().groups, [&](const dataflow::GroupChange& change) {
            return change.group == group_ && !change.may_keep;
        });
    }

    [[nodiscard]] bool leaves_rapid(const ProgramAnalysis& callee) const {
        return control_.rapid &&
               std::ranges::any_of(callee.summary().groups, [&](const dataflow::GroupChange& change) {
                   return change.group == control_.rapid->group && !change.may_keep && !change.other &&
                          std::ranges::all_of(change.codes,
                                              [&](double code) { return code == control_.rapid->code; });
               });
    }

    const Workspace& workspace_;
    const ControlModel& control_;
    GroupId group_;
    bool about_value_; ///< feed or speed: a rapid move does not ask for it
    std::vector<Point> stack_;
    std::unordered_set<std::uint64_t> visited_;
    Aftermath result_{false, nullptr, {}};
};

} // namespace

Aftermath aftermath_of(const ProgramAnalysis& callee, GroupId group) { return Search(callee, group).run(); }

} // namespace maclint
