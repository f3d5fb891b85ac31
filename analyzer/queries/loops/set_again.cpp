//! Follows a round from the loop's head to the assignments, and from these to the exits.
#include "analyzer/queries/loops/set_again.hpp"

#include "analyzer/dataflow/domain/read_set.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/flow/walk.hpp"

#include <algorithm>
#include <vector>

namespace maclint::queries {
namespace {

using dataflow::Store;

class Rounds {
  public:
    Rounds(const ProgramAnalysis& analysis, const dataflow::Loop& loop)
        : analysis_(analysis)
        , loop_(loop) {}

    /// Of a variable that the loop changes: the assignment that makes it the same at `exit` in every round.
    [[nodiscard]] const Store* fixed_before(Variable variable, flow::NodeId exit) const {
        std::vector<const Store*> stores;
        for (const Store* store : analysis_.facts().about<Store>(variable))
            if (loop_.holds(store->node)) stores.push_back(store);
        const auto sets = std::ranges::find_if(stores, [&](const Store* store) {
            return !store->step && reads_what_stays(store->expression, std::nullopt) &&
                   always_passes(loop_.head, exit, store->node);
        });
        if (sets == stores.end()) return nullptr;
        const bool others_are_steps = std::ranges::all_of(stores, [&](const Store* store) {
            if (store == *sets || !may_pass((*sets)->node, exit, store->node)) return true;
            return reads_what_stays(store->expression, variable) &&
                   always_passes((*sets)->node, exit, store->node);
        });
        return others_are_steps ? *sets : nullptr;
    }

    /// Whether every round comes by the node.
    [[nodiscard]] bool is_in_every_round(flow::NodeId node) const {
        return node == loop_.head || always_passes(loop_.head, loop_.head, node);
    }

  private:
    /// Whether the value is the same in every round, `own` aside.
    [[nodiscard]] bool reads_what_stays(ExpressionId id, std::optional<Variable> own) const {
        const dataflow::ReadSet set = dataflow::variables_of(analysis_.program(), id);
        return set.closed && std::ranges::all_of(set.variables, [&](Variable variable) {
                   return variable == own || !loop_.changes.may_change(variable);
               });
    }

    /// Whether a path of one round leads from one node to the other, without `around`.
    [[nodiscard]] bool leads(flow::NodeId from, flow::NodeId to, std::optional<flow::NodeId> around) const {
        bool found = false;
        flow::walk<flow::Direction::forward>(
            analysis_.graph(), {from}, [&](flow::EdgeId edge, flow::NodeId node) {
                if (found || node == around || !loop_.holds(node) || !analysis_.data().passable(edge))
                    return flow::Step::refuse;
                found = node == to;
                return node == loop_.head ? flow::Step::end : flow::Step::go_on;
            });
        return found || !Budget::allows();
    }

    [[nodiscard]] bool always_passes(flow::NodeId from, flow::NodeId to, flow::NodeId by) const {
        return from == by || !leads(from, to, by);
    }

    [[nodiscard]] bool may_pass(flow::NodeId from, flow::NodeId to, flow::NodeId by) const {
        return by == from || (leads(from, by, std::nullopt) && (by == to || leads(by, to, std::nullopt)));
    }

    const ProgramAnalysis& analysis_;
    const dataflow::Loop& loop_;
};

} // namespace

std::optional<SetAgain> set_again(const ProgramAnalysis& analysis, const dataflow::Loop& loop) {
    if (loop.exit_edges.empty()) return std::nullopt;
    const Rounds rounds(analysis, loop);
    std::optional<SetAgain> found;
    for (const flow::EdgeId id : loop.exit_edges) {
        const flow::Edge& exit = analysis.graph().edges[id];
        if (!exit.condition || exit.from == loop.head || !rounds.is_in_every_round(exit.from))
            return std::nullopt;
        const dataflow::ReadSet set = dataflow::variables_of(analysis.program(), *exit.condition);
        if (!set.closed) return std::nullopt;
        for (const Variable variable : set.variables) {
            if (!loop.changes.may_change(variable)) continue;
            if (loop.changes.clobbered(variable)) return std::nullopt;
            const dataflow::Store* store = rounds.fixed_before(variable, exit.from);
            if (store == nullptr) return std::nullopt;
            if (!found) found = SetAgain{store->effect, *exit.condition};
        }
    }
    return found;
}

} // namespace maclint::queries
