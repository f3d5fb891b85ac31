//! Solves against the flow: what is read behind an effect is asked of the effects in front of it.
#include "analyzer/dataflow/solver/liveness.hpp"

#include "analyzer/dataflow/solver/variable_sets.hpp"
#include "analyzer/flow/solve.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/overloaded.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <utility>

namespace maclint::dataflow {

/// What effects read and replace.
class LiveVariables {
  public:
    using State = LiveSet;

    LiveVariables(const Program& program, const flow::Graph& graph, Liveness::Locals locals)
        : program_(program)
        , graph_(graph)
        , sets_(program, graph) {
        collect_reads_by_moves();
        for (const flow::Exit& exit : graph.exits) add_read_after(exit, locals);
    }

    // ---- as a domain

    /// Every node may be the last one: a loop that is never left still reads what it asks for.
    [[nodiscard]] LiveSet at_begin(flow::NodeId node) const {
        const auto exit = at_exit_.find(node);
        return exit == at_exit_.end() ? sets_.none() : exit->second;
    }

    [[nodiscard]] static bool is_reached(const LiveSet& live) { return !live.empty(); }
    [[nodiscard]] static bool add(LiveSet& live, const LiveSet& more) {
        if (live.empty()) {
            live = more;
            return true;
        }
        bool grows = false;
        for (std::size_t i = 0; i < live.size(); ++i) {
            grows |= (more[i] & ~live[i]) != 0;
            live[i] |= more[i];
        }
        return grows;
    }
    /// Conditions are read in the node that asks them.
    void run(flow::NodeId node, LiveSet& live) const {
        const flow::Node& n = graph_.nodes[node];
        if (n.is_run) {
            if (moves(program_, n.stretch())) VariableSets::add_all(live, read_by_moves_);
            return;
        }
        for (Id i = n.effects.first + n.effects.count; i > n.effects.first;) go_back_over(node, --i, live);
    }

    /// From the state after the effect to the one in front of it.
    void go_back_over(flow::NodeId node, EffectId id, LiveSet& live) const {
        const auto add_reads = [&](std::optional<ExpressionId> read) { sets_.add_reads(read, live); };
        std::visit(overloaded{
                       [&](const Assign& what) { sets_.go_back_over(node, what, live); },
                       [&](const SetModal& what) { add_reads(what.value); },
                       [&](const EvaluateWords& what) {
                           for (const ExpressionId value : program_.values_of(what)) add_reads(value);
                       },
                       [&](const Motion&) { VariableSets::add_all(live, read_by_moves_); },
                       [&](const Stop& what) { add_reads(what.number); },
                       [&](const Reference& what) { add_reads(what.block); },
                       [&](const RegionMark& what) { add_reads(what.condition); },
                       [&](const Guarded& what) { add_reads(what.condition); },
                       [&](const Jump& what) { add_reads(what.target); },
                       [&](const Call& what) { call(what, live); },
                       [&](const Return& what) {
                           add_reads(what.value);
                           add_reads(what.resume_label);
                       },
                       [&](const Exchange& what) {
                           for (const ExpressionId out : program_.values_of(what)) add_reads(out);
                       },
                       [&](const UnreadableBlock& what) {
                           for (const Variable variable : program_.variables_of(what))
                               sets_.add(variable, live);
                           if (what.may_call_or_return) add_shared(live);
                       },
                       [](const ToolChange&) {},
                       [](const Synchronise&) {},
                   },
                   program_.effects[id].what);
    }

    [[nodiscard]] std::size_t words() const { return sets_.none().size(); }
    /// All variables that the program names.
    [[nodiscard]] std::vector<Variable> all() const {
        LiveSet all = sets_.none();
        sets_.add_if(all, [](SpaceId) { return true; });
        return sets_.members(all);
    }
    [[nodiscard]] std::vector<Variable> members(const LiveSet& live) const { return sets_.members(live); }
    [[nodiscard]] bool holds(const LiveSet& live, Variable variable) const {
        return sets_.holds(live, variable);
    }

  private:
    void collect_reads_by_moves() {
        read_by_moves_ = sets_.none();
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
        LiveSet& live = at_exit_.try_emplace(exit.node, sets_.none()).first->second;
        add_shared(live);
        if (exit.kind == flow::ExitKind::ends || exit.kind == flow::ExitKind::alarm) return;
        if (locals == Liveness::Locals::outlive_it || exit.kind == flow::ExitKind::restarts) add_locals(live);
        add_handed_down(live);
        for (const Formal& formal : program_.formals)
            if (formal.passing == Passing::by_reference) sets_.add(formal.variable, live);
    }

    // ---- sets

    [[nodiscard]] const VariableSpace& space(SpaceId id) const { return program_.control->spaces[id]; }
    void add_shared(LiveSet& set) const {
        sets_.add_if(set, [&](SpaceId id) { return space(id).scope != Scope::frame; });
    }
    void add_locals(LiveSet& set) const {
        sets_.add_if(set, [&](SpaceId id) { return space(id).scope == Scope::frame; });
    }
    /// What this program hands down, and what its callers may have: that goes on to those called here.
    void add_handed_down(LiveSet& set) const {
        for (const Variable variable : program_.handed_down) sets_.add(variable, set);
        sets_.add_if(set, [&](SpaceId id) { return space(id).handed_down; });
    }

    // ---- effects

    [[nodiscard]] const CallKind& kind_of(const Call& call) const {
        return program_.control->calls[call.kind];
    }

    void call(const Call& call, LiveSet& live) const {
        if (kind_of(call).trigger == CallTrigger::once) add_visible_to(call, live);
        for (const Argument& argument : program_.arguments_of(call)) sets_.add_reads(argument.value, live);
        sets_.add_reads(call.repeat, live);
        if (const auto* name = std::get_if<ExpressionId>(&call.program)) sets_.add_reads(*name, live);
    }

    /// What the called program can read.
    void add_visible_to(const Call& call, LiveSet& set) const {
        add_shared(set);
        if (kind_of(call).frame == Frame::shared) add_locals(set);
        add_handed_down(set);
    }

    const Program& program_;
    const flow::Graph& graph_;
    VariableSets sets_;
    LiveSet read_by_moves_;
    std::unordered_map<flow::NodeId, LiveSet> at_exit_;
};

namespace {

/// The bound for all sets of a program together, in words of 8 bytes. No program written by a person comes
/// near.
constexpr std::size_t most_words = 8'000'000;

} // namespace

Liveness::Liveness(const Program& program, const flow::Graph& graph, Locals locals)
    : graph_(&graph)
    , variables_(std::make_unique<const LiveVariables>(program, graph, locals)) {
    if (variables_->words() * graph.nodes.size() > most_words) return;
    is_known_ = true;
    const std::vector<LiveSet> sets = flow::solve<flow::Direction::backward>(graph, *variables_);
    if (!sets.empty()) words_ = sets.front().size();
    after_.reserve(sets.size() * words_);
    for (const LiveSet& set : sets) after_.insert(after_.end(), set.begin(), set.end());
}

Liveness::Liveness(Liveness&&) noexcept = default;
Liveness& Liveness::operator=(Liveness&&) noexcept = default;
Liveness::~Liveness() = default;

LiveSet Liveness::after(flow::NodeId node) const {
    LiveSet set(words_, 0);
    std::copy_n(after_.begin() + static_cast<std::ptrdiff_t>(node * words_), words_, set.begin());
    return set;
}

bool Liveness::is_live_after(EffectId effect, Variable variable) const {
    const auto node = graph_->node_of(effect);
    if (!node || !is_known_) return true;
    LiveSet live = after(*node);
    const Slice effects = graph_->nodes[*node].effects;
    for (Id i = effects.first + effects.count; i > effect + 1;) variables_->go_back_over(*node, --i, live);
    return variables_->holds(live, variable);
}

std::vector<Variable> Liveness::live_before(flow::NodeId node) const {
    if (!is_known_) return variables_->all();
    LiveSet live = after(node);
    variables_->run(node, live);
    return variables_->members(live);
}

} // namespace maclint::dataflow
