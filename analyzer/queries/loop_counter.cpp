//! Looks at every exit of a loop, and at every assignment in it.
#include "analyzer/queries/loop_counter.hpp"

#include "analyzer/dataflow/domain/arithmetic.hpp"
#include "analyzer/dataflow/domain/read_set.hpp"

#include <algorithm>
#include <utility>

namespace maclint::queries {
namespace {

/// The assignments in the loop's body that change the variable.
std::vector<const dataflow::Store*> stores_in(const dataflow::Loop& loop, const dataflow::Facts& facts,
                                              Variable variable) {
    std::vector<const dataflow::Store*> stores;
    dataflow::for_each_in_body(loop, facts.all<dataflow::Store>(), [&](const dataflow::Store& store) {
        if (store.variable == variable) stores.push_back(&store);
    });
    return stores;
}

/// Finds the counter of one loop, or why there is none.
class CounterSearch {
  public:
    CounterSearch(const Program& program, const flow::Graph& graph, const dataflow::Facts& facts,
                  const dataflow::Loop& loop)
        : program_(program)
        , graph_(graph)
        , facts_(facts)
        , loop_(loop) {}

    std::optional<Counter> run() {
        for (const flow::EdgeId id : loop_.exit_edges) {
            const flow::Edge& edge = graph_.edges[id];
            if (!edge.condition || !add_test(edge)) return std::nullopt;
        }
        if (!counter_ || loop_.changes.clobbered(counter_->variable)) return std::nullopt;
        for (const dataflow::Store* store : stores_in(loop_, facts_, counter_->variable)) {
            if (store->step)
                counter_->steps.push_back(store);
            else if (is_clamp(*store))
                counter_->clamps.push_back(store);
            else
                return std::nullopt;
        }
        return counter_->steps.empty() ? std::nullopt : std::move(counter_);
    }

  private:
    [[nodiscard]] bool is_fixed(ExpressionId expression) const {
        const dataflow::ReadSet set = dataflow::variables_of(program_, expression);
        return set.closed && std::ranges::none_of(set.variables, [this](Variable variable) {
                   return loop_.changes.may_change(variable);
               });
    }

    /// A side that is the variable, or minus the variable.
    [[nodiscard]] std::optional<std::pair<Variable, bool>> side(ExpressionId id) const {
        bool negated = false;
        const auto* apply = std::get_if<Apply>(&program_.expressions[id].node);
        if (apply != nullptr && apply->operation == Operation::negate) {
            negated = true;
            id = program_.operands_of(*apply).front();
        }
        const auto* load = std::get_if<Load>(&program_.expressions[id].node);
        if (load == nullptr || !loop_.changes.may_change(load->variable)) return std::nullopt;
        return std::pair(load->variable, negated);
    }

    bool add_test(const flow::Edge& edge) {
        const auto comparisons = facts_.in<dataflow::Comparison>(edge.from);
        const auto found = std::ranges::find(comparisons, *edge.condition, &dataflow::Comparison::expression);
        if (found == comparisons.end() || !dataflow::is_comparison(found->operation)) return false;
        // The exit is taken when the comparison `holds`; the loop goes on otherwise.
        Operation stays = edge.holds ? dataflow::opposite(found->operation) : found->operation;
        ExpressionId bound = found->right_expression;
        const dataflow::Value* bound_value = &found->right;
        auto variable = side(found->left_expression);
        if (!variable) {
            variable = side(found->right_expression);
            bound = found->left_expression;
            bound_value = &found->left;
            stays = dataflow::mirrored(stays);
        }
        if (!variable || !is_fixed(bound)) return false;
        if (variable->second) stays = dataflow::mirrored(stays);
        if (!counter_) counter_ = Counter{variable->first, {}, {}, {}};
        if (!(counter_->variable == variable->first)) return false;
        counter_->tests.push_back({&*found, stays, bound, bound_value});
        return true;
    }

    /// IF[#13GT#26]THEN#13=#26
    [[nodiscard]] bool is_clamp(const dataflow::Store& store) const {
        const auto guarded = [&](flow::EdgeId id) {
            const auto& condition = graph_.edges[id].condition;
            if (!condition) return false;
            const dataflow::ReadSet set = dataflow::variables_of(program_, *condition);
            return std::ranges::find(set.variables, store.variable) != set.variables.end();
        };
        return !graph_.in[store.node].empty() && std::ranges::all_of(graph_.in[store.node], guarded);
    }

    const Program& program_;
    const flow::Graph& graph_;
    const dataflow::Facts& facts_;
    const dataflow::Loop& loop_;
    std::optional<Counter> counter_;
};

} // namespace

std::optional<Counter> counter_of(const ProgramAnalysis& analysis, const dataflow::Loop& loop) {
    return CounterSearch(analysis.program(), analysis.graph(), analysis.facts(), loop).run();
}

} // namespace maclint::queries
