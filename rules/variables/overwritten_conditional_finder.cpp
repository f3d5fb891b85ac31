//! Goes on from each assignment under a condition to the next test that sets the same variable.
#include "rules/variables/overwritten_conditional_finder.hpp"

#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/execution/path_search.hpp"
#include "analyzer/queries/conditions/conditions.hpp"
#include "analyzer/queries/machine/changing_values.hpp"
#include "analyzer/semantics/concrete.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace maclint::rules {
namespace {

constexpr int most_nodes = 32; ///< from an assignment to the test that sets its variable again

/// A node that decides, with what follows when its condition is true, and when it is not.
struct Decision {
    ExpressionId condition;
    flow::NodeId if_true, if_false;
};

class CoveredCases {
  public:
    explicit CoveredCases(const ProgramAnalysis& analysis)
        : analysis_(analysis)
        , program_(analysis.program())
        , graph_(analysis.graph()) {}

    [[nodiscard]] std::optional<CoveredCase> of(const dataflow::Store& store) const {
        const auto condition = condition_of(store.node);
        if (!condition || reads(store.node, store.variable)) return std::nullopt;
        auto node = next_of(store.node);
        for (int i = 0; node && i < most_nodes; ++i) {
            if (!only_calculates(*node) || reads(*node, store.variable)) return std::nullopt;
            const auto decision = decision_at(*node);
            if (!decision) {
                if (store_in(*node, store.variable) != nullptr) return std::nullopt; // in every case
                node = next_of(*node);
                continue;
            }
            // An index may read the variable, and an input may be another the second time.
            if (reads(decision->if_true, store.variable) ||
                queries::reads_what_changes(analysis_, decision->condition))
                return std::nullopt;
            if (const dataflow::Store* later = store_in(decision->if_true, store.variable)) {
                // A block that stands there twice loses nothing.
                if (queries::same_expression(program_, store.expression, later->expression) ||
                    holds_by_a_setting(*node, *condition, decision->condition) ||
                    !is_always_made(store.node, *decision))
                    return std::nullopt;
                return CoveredCase{&store, *condition, later, decision->condition};
            }
            // Another variable's case, which goes on where its test does.
            if (!only_calculates(decision->if_true) || next_of(decision->if_true) != decision->if_false)
                return std::nullopt;
            node = decision->if_false;
        }
        return std::nullopt;
    }

  private:
    /// The condition that alone leads to the node.
    [[nodiscard]] std::optional<ExpressionId> condition_of(flow::NodeId node) const {
        const auto in = graph_.in[node];
        return in.size() == 1 ? graph_.edges[in.front()].condition : std::nullopt;
    }
    /// The only node that comes after it.
    [[nodiscard]] std::optional<flow::NodeId> next_of(flow::NodeId node) const {
        const auto out = graph_.out[node];
        if (out.size() != 1 || !graph_.exits_at(node).empty()) return std::nullopt;
        return graph_.edges[out.front()].to;
    }
    [[nodiscard]] std::optional<Decision> decision_at(flow::NodeId node) const {
        const auto out = graph_.out[node];
        if (out.size() != 2) return std::nullopt;
        const flow::Edge& one = graph_.edges[out[0]];
        const flow::Edge& two = graph_.edges[out[1]];
        if (!one.condition || one.condition != two.condition || one.holds == two.holds) return std::nullopt;
        return Decision{*one.condition, (one.holds ? one : two).to, (one.holds ? two : one).to};
    }

    /// Whether the second condition follows from the first only by the number that the text sets what they
    /// ask for to: `#1=70.`, `IF[#1GT30.]`, `IF[#1GT60.]`. Who edits it has the other case.
    [[nodiscard]] bool holds_by_a_setting(flow::NodeId node, ExpressionId first, ExpressionId second) const {
        const auto reads = analysis_.facts().in<dataflow::Read>(node);
        if (std::ranges::none_of(
                reads, [](const dataflow::Read& read) { return read.value.constant().has_value(); }))
            return false;
        const auto* a = std::get_if<Apply>(&program_.expressions[first].node);
        const auto* b = std::get_if<Apply>(&program_.expressions[second].node);
        if (a == nullptr || b == nullptr || a->operation != b->operation ||
            !semantics::is_order(a->operation))
            return false;
        const auto of_a = program_.operands_of(*a), of_b = program_.operands_of(*b);
        const auto* limit_a = std::get_if<Literal>(&program_.expressions[of_a[1]].node);
        const auto* limit_b = std::get_if<Literal>(&program_.expressions[of_b[1]].node);
        if (limit_a == nullptr || limit_b == nullptr || !queries::same_expression(program_, of_a[0], of_b[0]))
            return false;
        const bool upwards = a->operation == Operation::greater || a->operation == Operation::greater_equal;
        return upwards ? limit_a->value < limit_b->value : limit_a->value > limit_b->value;
    }

    [[nodiscard]] const dataflow::Store* store_in(flow::NodeId node, Variable variable) const {
        const auto stores = analysis_.facts().in<dataflow::Store>(node);
        const auto found = std::ranges::find(stores, variable, &dataflow::Store::variable);
        return found == stores.end() ? nullptr : &*found;
    }
    [[nodiscard]] bool reads(flow::NodeId node, Variable variable) const {
        const auto reads = analysis_.facts().in<dataflow::Read>(node);
        return std::ranges::find(reads, variable, &dataflow::Read::variable) != reads.end();
    }
    /// Whether nothing else than assignments to variables, tests and jumps is there, and no index.
    [[nodiscard]] bool only_calculates(flow::NodeId node) const {
        return !graph_.nodes[node].is_run &&
               std::ranges::all_of(
                   program_.effects_in(graph_.nodes[node].effects), [&](const Effect& effect) {
                       const auto* assign = std::get_if<Assign>(&effect.what);
                       const bool is_plain = assign != nullptr &&
                                             std::holds_alternative<Variable>(assign->target) &&
                                             !has_index(assign->value);
                       return is_plain || std::holds_alternative<Jump>(effect.what) ||
                              std::holds_alternative<Guarded>(effect.what) ||
                              std::holds_alternative<RegionMark>(effect.what);
                   });
    }
    [[nodiscard]] bool has_index(ExpressionId id) const {
        const auto& node = program_.expressions[id].node;
        const auto* apply = std::get_if<Apply>(&node);
        return std::holds_alternative<LoadAt>(node) ||
               (apply != nullptr &&
                std::ranges::any_of(program_.operands_of(*apply),
                                    [&](ExpressionId operand) { return has_index(operand); }));
    }

    /// Whether no path that comes over the node can find the decision's condition false.
    [[nodiscard]] bool is_always_made(flow::NodeId node, const Decision& decision) const {
        const std::array barred{decision.if_true};
        execution::PathSearch search(analysis_);
        const execution::PathFound comes = search.find(std::array{execution::Leg{node, {}}});
        if (!comes.path) return false; // nothing is run there
        const execution::PathFound around =
            search.find(std::array{execution::Leg{node, {}}, execution::Leg{decision.if_false, barred}});
        return !around.path && !around.gave_up && !around.may_miss;
    }

    const ProgramAnalysis& analysis_;
    const Program& program_;
    const flow::Graph& graph_;
};

} // namespace

std::vector<CoveredCase> find_covered_cases(const ProgramAnalysis& analysis) {
    std::vector<CoveredCase> found;
    const CoveredCases cases(analysis);
    for (const dataflow::Store& store : analysis.facts().all<dataflow::Store>())
        if (const auto covered = cases.of(store)) found.push_back(*covered);
    return found;
}

} // namespace maclint::rules
