//! Holds what decides over the callee's alarms against what the loop changes.
#include "analyzer/dataflow/loop_stops.hpp"

#include "analyzer/dataflow/domain/read_set.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/flow/walk.hpp"

#include <algorithm>
#include <vector>

namespace maclint::dataflow {
namespace {

/// What may be another number in another round of a loop, at a node of it. A variable that is set anew in
/// each round, from nothing that changes, is not.
class Rounds {
  public:
    Rounds(const Program& program, const flow::Graph& graph, const Analysis& analysis, const Loop& loop)
        : program_(program)
        , graph_(graph)
        , analysis_(analysis)
        , loop_(loop) {}

    [[nodiscard]] bool differs(Variable variable, flow::NodeId at) const {
        return differs(variable, at, most_assignments);
    }

    [[nodiscard]] bool differs(ExpressionId expression, flow::NodeId at, int left = most_assignments) const {
        const ReadSet reads = variables_of(program_, expression);
        return !reads.closed || std::ranges::any_of(reads.variables, [&](Variable variable) {
            return differs(variable, at, left);
        });
    }

  private:
    static constexpr int most_assignments = 8; ///< one made of another

    [[nodiscard]] bool differs(Variable variable, flow::NodeId at, int left) const {
        if (!loop_.changes.may_change(variable)) return false;
        if (left == 0 || loop_.changes.clobbered(variable)) return true;
        std::vector<const Store*> stores;
        for_each_in_body(loop_, analysis_.facts().all<Store>(), [&](const Store& store) {
            if (store.variable == variable && !adds_nothing(store)) stores.push_back(&store);
        });
        if (stores.empty()) return false;
        return stores.size() != 1 || !is_always_made(*stores.front(), at) ||
               differs(stores.front()->expression, stores.front()->node, left - 1);
    }

    static bool adds_nothing(const Store& store) {
        return store.step && store.step->amount.constant() == 0.0;
    }

    /// Whether each round makes the assignment before it comes to the node.
    [[nodiscard]] bool is_always_made(const Store& store, flow::NodeId at) const {
        const Slice effects = graph_.nodes[store.node].effects;
        const bool without_condition =
            store.effect >= effects.first && store.effect < effects.first + effects.count;
        if (!without_condition || store.node == at) return false;
        if (store.node == loop_.head) return true;
        bool reached = at == loop_.head;
        flow::walk<flow::Direction::forward>(graph_, {loop_.head}, [&](flow::EdgeId edge, flow::NodeId to) {
            if (reached || to == store.node || !loop_.holds(to) || !analysis_.passable(edge))
                return flow::Step::refuse;
            reached = to == at;
            return flow::Step::go_on;
        });
        return !reached;
    }

    const Program& program_;
    const flow::Graph& graph_;
    const Analysis& analysis_;
    const Loop& loop_;
};

/// Whether what the call passes for the variable may be another number in another round. What it leaves out
/// is always vacant.
bool passes_other_numbers(const Program& program, const CallMade& made, Variable variable,
                          const Rounds& rounds) {
    const auto& call = std::get<Call>(program.effects[made.effect].what);
    return std::ranges::any_of(program.arguments_of(call), [&](const Argument& argument) {
        const auto* letter = std::get_if<Variable>(&argument.given);
        if (letter == nullptr) return true; // only the workspace knows what it means
        return *letter == variable && rounds.differs(argument.value, made.node);
    });
}

} // namespace

bool may_stop_later(const Program& program, const flow::Graph& graph, const Analysis& analysis,
                    const CallMade& made, const Loop& loop) {
    if (!made.may_stop || !made.known) return made.may_stop;
    const StopReasons& reasons = analysis.callee(made.effect).summary.stop_reasons;
    if (reasons.anything) return true;
    const Rounds rounds(program, graph, analysis, loop);
    const auto& call = std::get<Call>(program.effects[made.effect].what);
    const bool shared_frame = program.control->calls[call.kind].frame == Frame::shared;
    return std::ranges::any_of(reasons.variables, [&](Variable variable) {
        const VariableSpace& space = program.control->spaces[variable.space];
        if (space.named) return true; // numbered differently in each program
        if (space.scope == Scope::frame && !shared_frame)
            return passes_other_numbers(program, made, variable, rounds);
        return rounds.differs(variable, made.node);
    });
}

} // namespace maclint::dataflow
