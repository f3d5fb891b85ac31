//! Solves against the flow: what is read behind an effect is asked of the effects in front of it.
#include "analyzer/dataflow/solver/liveness.hpp"

#include "analyzer/flow/solve.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/overloaded.hpp"

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <utility>

namespace maclint::dataflow {
namespace {

constexpr std::size_t word_bits = 64;

void add_all(LiveSet& to, const LiveSet& from) {
    for (std::size_t i = 0; i < to.size(); ++i) to[i] |= from[i];
}

} // namespace

/// What effects read and replace.
class LiveVariables {
  public:
    using State = LiveSet;

    LiveVariables(const Program& program, const flow::Graph& graph, Liveness::Locals locals)
        : program_(program)
        , graph_(graph) {
        number_variables();
        collect_reads_by_moves();
        for (const flow::Exit& exit : graph.exits) add_read_after(exit, locals);
    }
    /// Of decisions on the way to the goal.
    LiveVariables(const Program& program, const flow::Graph& graph, const Callees& callees, flow::NodeId goal)
        : program_(program)
        , graph_(graph)
        , callees_(&callees) {
        number_variables();
        read_by_moves_ = none();
        at_exit_.try_emplace(goal, none());
    }

    // ---- as a domain

    /// Every node may be the last one: who never leaves a loop reads what it asks for all the same. On the
    /// way to a goal that is the last one.
    [[nodiscard]] State at_begin(flow::NodeId node) const {
        const auto exit = at_exit_.find(node);
        if (exit != at_exit_.end()) return exit->second;
        return of_decisions() ? LiveSet{} : none();
    }
    [[nodiscard]] static bool is_reached(const State& state) { return !state.empty(); }
    [[nodiscard]] static bool equal(const State& a, const State& b) { return a == b; }
    [[nodiscard]] static State join(State a, const State& b, flow::NodeId) {
        if (a.empty()) return b;
        if (!b.empty()) add_all(a, b);
        return a;
    }
    [[nodiscard]] State run(flow::NodeId node, State state) const {
        const flow::Node& n = graph_.nodes[node];
        if (n.is_run) {
            if (moves(program_, n.stretch())) add_all(state, read_by_moves_);
            return state;
        }
        for (Id i = n.effects.first + n.effects.count; i > n.effects.first;) pass(node, --i, state);
        return state;
    }
    /// Conditions are read in the node that asks them.
    [[nodiscard]] static State along(const flow::Edge&, const State& state) { return state; }

    /// From the state after the effect to the one in front of it.
    void pass(flow::NodeId node, EffectId id, LiveSet& live) const {
        if (of_decisions())
            pass_decision(node, id, live);
        else
            pass_any(node, id, live);
    }

    [[nodiscard]] std::vector<Variable> members(const LiveSet& live) const {
        std::vector<Variable> all;
        for (const auto& [variable, place] : places_)
            if (!live.empty() && (live[place / word_bits] & bit(place)) != 0) all.push_back(variable);
        return all;
    }

    [[nodiscard]] bool holds(const LiveSet& live, Variable variable) const {
        const auto place = places_.find(program_.meant_by(variable));
        return place == places_.end() || (live[place->second / word_bits] & bit(place->second)) != 0;
    }

  private:
    [[nodiscard]] bool of_decisions() const { return callees_ != nullptr; }

    /// What is stored is read only where somebody decides by it.
    void pass_decision(flow::NodeId node, EffectId id, LiveSet& live) const {
        std::visit(overloaded{
                       [&](const Assign& what) {
                           const auto* variable = std::get_if<Variable>(&what.target);
                           if (variable != nullptr && !holds(live, *variable)) return;
                           assign(node, what, live);
                       },
                       [&](const RegionMark& what) { add_reads(what.condition, live); },
                       [&](const Guarded& what) { add_reads(what.condition, live); },
                       [&](const Jump& what) { add_reads(what.target, live); },
                       [&](const Call& what) { call_that_decides(id, what, live); },
                       [](const auto&) {},
                   },
                   program_.effects[id].what);
    }

    void assign(flow::NodeId node, const Assign& what, LiveSet& live) const {
        if (const auto* variable = std::get_if<Variable>(&what.target))
            replace(node, *variable, live);
        else if (const auto* indexed = std::get_if<StoreAt>(&what.target))
            add_reads(indexed->index, live);
        add_reads(what.value, live);
    }

    void pass_any(flow::NodeId node, EffectId id, LiveSet& live) const {
        std::visit(overloaded{
                       [&](const Assign& what) { assign(node, what, live); },
                       [&](const SetModal& what) { add_reads(what.value, live); },
                       [&](const EvaluateWords& what) {
                           for (const ExpressionId value : program_.values_of(what)) add_reads(value, live);
                       },
                       [&](const Motion&) { add_all(live, read_by_moves_); },
                       [&](const Stop& what) { add_reads(what.number, live); },
                       [&](const Reference& what) { add_reads(what.block, live); },
                       [&](const RegionMark& what) { add_reads(what.condition, live); },
                       [&](const Guarded& what) { add_reads(what.condition, live); },
                       [&](const Jump& what) { add_reads(what.target, live); },
                       [&](const Call& what) { call(what, live); },
                       [&](const Return& what) {
                           add_reads(what.value, live);
                           add_reads(what.resume_label, live);
                       },
                       [&](const Exchange& what) {
                           for (const ExpressionId out : what.out) add_reads(out, live);
                       },
                       [&](const UnreadableBlock& what) {
                           for (const Variable variable : what.may_write) add(variable, live);
                           if (what.may_call_or_return) add_shared(live);
                       },
                       [](const ToolChange&) {},
                       [](const Synchronise&) {},
                   },
                   program_.effects[id].what);
    }

    void number_variables() {
        const auto number = [&](Variable variable) {
            places_.try_emplace(program_.meant_by(variable), places_.size());
        };
        for (const Expression& expression : program_.expressions)
            if (const auto* load = std::get_if<Load>(&expression.node)) number(load->variable);
        for (const Effect& effect : program_.effects)
            if (const auto* assign = std::get_if<Assign>(&effect.what))
                if (const auto* variable = std::get_if<Variable>(&assign->target)) number(*variable);
    }

    void collect_reads_by_moves() {
        read_by_moves_ = none();
        bool calls = false;
        for_each_effect(program_, [&](EffectId id) {
            const auto* call = std::get_if<Call>(&program_.effects[id].what);
            if (call == nullptr) return;
            calls = true;
            if (kind_of(*call).trigger != CallTrigger::once) add_visible_to(*call, read_by_moves_);
        });
        if (calls) add_shared(read_by_moves_); // a called program may leave a modal call of its own in force
    }

    void add_read_after(const flow::Exit& exit, Liveness::Locals locals) {
        LiveSet& live = at_exit_.try_emplace(exit.node, none()).first->second;
        add_shared(live);
        if (exit.kind == flow::ExitKind::ends || exit.kind == flow::ExitKind::alarm) return;
        if (locals == Liveness::Locals::outlive_it || exit.kind == flow::ExitKind::restarts) add_locals(live);
        add_handed_down(live);
        for (const Formal& formal : program_.formals)
            if (formal.passing == Passing::by_reference) add(formal.variable, live);
    }

    // ---- sets

    [[nodiscard]] static std::uint64_t bit(std::size_t place) {
        return std::uint64_t{1} << place % word_bits;
    }
    [[nodiscard]] LiveSet none() const { return LiveSet(places_.size() / word_bits + 1, 0); }
    void add(Variable variable, LiveSet& set) const {
        const auto place = places_.find(program_.meant_by(variable));
        if (place != places_.end()) set[place->second / word_bits] |= bit(place->second);
    }
    template<class Wanted>
    void add_if(LiveSet& set, const Wanted& wanted) const {
        for (const auto& [variable, place] : places_)
            if (wanted(variable.space)) set[place / word_bits] |= bit(place);
    }
    [[nodiscard]] const VariableSpace& space(SpaceId id) const { return program_.control->spaces[id]; }
    void add_shared(LiveSet& set) const {
        add_if(set, [&](SpaceId id) { return space(id).scope != Scope::frame; });
    }
    void add_locals(LiveSet& set) const {
        add_if(set, [&](SpaceId id) { return space(id).scope == Scope::frame; });
    }
    /// What this program hands down, and what its callers may have: that goes on to those called here.
    void add_handed_down(LiveSet& set) const {
        for (const Variable variable : program_.handed_down) add(variable, set);
        add_if(set, [&](SpaceId id) { return space(id).handed_down; });
    }

    // ---- effects

    [[nodiscard]] const CallKind& kind_of(const Call& call) const {
        return program_.control->calls[call.kind];
    }

    /// What it held before is no longer asked for, when the store surely is one in this variable alone.
    void replace(flow::NodeId node, Variable variable, LiveSet& live) const {
        const bool may_be_another =
            space(variable.space).named && space(variable.space).scope != Scope::frame;
        if (may_be_another || graph_.channels_at(node).running != graph_.all_channels) return;
        const std::size_t place = places_.at(program_.meant_by(variable));
        live[place / word_bits] &= ~bit(place);
    }

    /// Whether it comes back depends on these, and on arguments, which seldom differ from path to path.
    void call_that_decides(EffectId id, const Call& call, LiveSet& live) const {
        for (const Variable variable : (*callees_)(id).summary.decides_end)
            if (kind_of(call).frame == Frame::shared || space(variable.space).scope != Scope::frame)
                add(variable, live);
    }

    void call(const Call& call, LiveSet& live) const {
        if (kind_of(call).trigger == CallTrigger::once) add_visible_to(call, live);
        for (const Argument& argument : program_.arguments_of(call)) add_reads(argument.value, live);
        add_reads(call.repeat, live);
        if (const auto* name = std::get_if<ExpressionId>(&call.program)) add_reads(*name, live);
    }

    /// What the called program can read.
    void add_visible_to(const Call& call, LiveSet& set) const {
        add_shared(set);
        if (kind_of(call).frame == Frame::shared) add_locals(set);
        add_handed_down(set);
    }

    /// Whether an index into the family can mean variables of the space.
    [[nodiscard]] bool reaches(FamilyId family, SpaceId id) const {
        return std::ranges::any_of(program_.control->families[family].ranges,
                                   [&](const VariableRange& range) {
                                       return range.meaning == Meaning::variable && range.space == id;
                                   });
    }

    void add_reads(std::optional<ExpressionId> id, LiveSet& set) const {
        if (!id) return;
        std::visit(overloaded{
                       [&](const Load& load) { add(load.variable, set); },
                       [&](const LoadAt& load) {
                           add_reads(load.index, set);
                           add_if(set, [&](SpaceId id) { return reaches(load.family, id); });
                       },
                       [&](const Apply& apply) {
                           for (const ExpressionId operand : program_.operands_of(apply))
                               add_reads(operand, set);
                       },
                       [](const auto&) {},
                   },
                   program_.expressions[*id].node);
    }

    const Program& program_;
    const flow::Graph& graph_;
    std::unordered_map<Variable, std::size_t, VariableHash> places_; ///< in a set
    LiveSet read_by_moves_;
    std::unordered_map<flow::NodeId, LiveSet> at_exit_;
    const Callees* callees_ = nullptr; ///< of decisions
};

Liveness::Liveness(const Program& program, const flow::Graph& graph, Locals locals)
    : Liveness(graph, std::make_unique<const LiveVariables>(program, graph, locals)) {}

Liveness Liveness::of_decisions(const Program& program, const flow::Graph& graph, const Callees& callees,
                                flow::NodeId goal) {
    return {graph, std::make_unique<const LiveVariables>(program, graph, callees, goal)};
}

Liveness::Liveness(const flow::Graph& graph, std::unique_ptr<const LiveVariables> variables)
    : graph_(&graph)
    , variables_(std::move(variables)) {
    flow::Solution<LiveSet> solution;
    flow::solve<flow::Direction::backward>(graph, *variables_, solution);
    after_ = std::move(solution.before);
}

Liveness::Liveness(Liveness&&) noexcept = default;
Liveness& Liveness::operator=(Liveness&&) noexcept = default;
Liveness::~Liveness() = default;

bool Liveness::is_live_after(EffectId effect, Variable variable) const {
    const auto node = graph_->node_of(effect);
    if (!node) return true;
    LiveSet live = after_[*node];
    const Slice effects = graph_->nodes[*node].effects;
    for (Id i = effects.first + effects.count; i > effect + 1;) variables_->pass(*node, --i, live);
    return variables_->holds(live, variable);
}

std::vector<Variable> Liveness::live_before(flow::NodeId node) const {
    if (!LiveVariables::is_reached(after_[node])) return {};
    return variables_->members(variables_->run(node, after_[node]));
}

} // namespace maclint::dataflow
