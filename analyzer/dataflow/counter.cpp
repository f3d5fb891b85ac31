//! What a loop changes, and which of it counts its rounds.
#include "analyzer/dataflow/counter.hpp"

#include "analyzer/dataflow/conditions.hpp"
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/loops.hpp"

#include <algorithm>
#include <utility>

namespace maclint::dataflow {

LoopChanges::LoopChanges(const Loop& loop, const Facts& facts) {
    for_each_in_body(loop, facts.all<Store>(),
                     [&](const Store& store) { assigned_.push_back(key_of(store.variable)); });
    for_each_in_body(loop, facts.all<Clobber>(), [&](const Clobber& clobber) {
        if (clobber.variable)
            clobbered_.push_back(key_of(*clobber.variable));
        else if (std::ranges::find(spaces_, clobber.space) == spaces_.end())
            spaces_.push_back(clobber.space);
    });
    std::ranges::sort(assigned_);
    std::ranges::sort(clobbered_);
}

bool LoopChanges::assigned(Variable variable) const {
    return std::ranges::binary_search(assigned_, key_of(variable));
}

bool LoopChanges::clobbered(Variable variable) const {
    return std::ranges::find(spaces_, variable.space) != spaces_.end() ||
           std::ranges::binary_search(clobbered_, key_of(variable));
}

namespace {

/// The assignments in the loop's body that change the variable.
std::vector<const Store*> stores_in(const Loop& loop, const Facts& facts, Variable variable) {
    std::vector<const Store*> stores;
    for_each_in_body(loop, facts.all<Store>(), [&](const Store& store) {
        if (store.variable == variable) stores.push_back(&store);
    });
    return stores;
}

/// Finds the counter of one loop, or why there is none.
class CounterSearch {
  public:
    CounterSearch(const Program& program, const flow::Graph& graph, const Facts& facts, const Loop& loop)
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
        for (const Store* store : stores_in(loop_, facts_, counter_->variable)) {
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
        const ReadSet set = variables_of(program_, expression);
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
        const auto comparisons = facts_.in<Comparison>(edge.from);
        const auto found = std::ranges::find(comparisons, *edge.condition, &Comparison::expression);
        if (found == comparisons.end() || !is_comparison(found->operation)) return false;
        // The exit is taken when the comparison `holds`; the loop goes on otherwise.
        Operation stays = edge.holds ? opposite(found->operation) : found->operation;
        ExpressionId bound = found->right_expression;
        const Value* bound_value = &found->right;
        auto variable = side(found->left_expression);
        if (!variable) {
            variable = side(found->right_expression);
            bound = found->left_expression;
            bound_value = &found->left;
            stays = mirrored(stays);
        }
        if (!variable || !is_fixed(bound)) return false;
        if (variable->second) stays = mirrored(stays);
        if (!counter_) counter_ = Counter{variable->first, {}, {}, {}};
        if (!(counter_->variable == variable->first)) return false;
        counter_->tests.push_back({&*found, stays, bound, bound_value});
        return true;
    }

    /// IF[#13GT#26]THEN#13=#26
    [[nodiscard]] bool is_clamp(const Store& store) const {
        const auto guarded = [&](flow::EdgeId id) {
            const auto& condition = graph_.edges[id].condition;
            if (!condition) return false;
            const ReadSet set = variables_of(program_, *condition);
            return std::ranges::find(set.variables, store.variable) != set.variables.end();
        };
        return !graph_.in[store.node].empty() && std::ranges::all_of(graph_.in[store.node], guarded);
    }

    const Program& program_;
    const flow::Graph& graph_;
    const Facts& facts_;
    const Loop& loop_;
    std::optional<Counter> counter_;
};

} // namespace

std::optional<Counter> counter_of(const Program& program, const flow::Graph& graph, const Facts& facts,
                                  const Loop& loop) {
    return CounterSearch(program, graph, facts, loop).run();
}

} // namespace maclint::dataflow
