//! Goes back from block to block as long as only one way leads to it.
#include "analyzer/queries/conditions/guards_before.hpp"

#include "analyzer/dataflow/domain/read_set.hpp"
#include "analyzer/dataflow/domain/state.hpp"
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/flow/walk.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/conditions/conditions.hpp"
#include "analyzer/semantics/truth.hpp"
#include "analyzer/source/budget.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace maclint::queries {
namespace {

using dataflow::Comparison;
using semantics::AbstractValue;
using semantics::Truth;

constexpr int most_nodes = 64; ///< of a row of guards

/// A number of the text.
bool has_number_on_right(const Program& program, const Comparison& comparison) {
    if (semantics::is_vacancy_test(comparison.operation)) return false;
    const auto right = dataflow::variables_of(program, comparison.right_expression);
    return right.closed && right.variables.empty() && comparison.right.constant();
}

AbstractValue any_number() {
    AbstractValue value;
    value.vacancy = semantics::Vacancy::set;
    return value;
}

/// What `later` is, whatever the value on its left, where `earlier` asked the same value and turned out so.
std::optional<bool> outcome_after(const ProgramAnalysis& analysis, const Comparison& earlier, bool holds,
                                  const Comparison& later) {
    if (!same_expression(analysis.program(), earlier.left_expression, later.left_expression))
        return std::nullopt;
    const bool zero = analysis.control().vacant_equals_zero;
    const Operation known = holds ? earlier.operation : semantics::opposite(earlier.operation);
    Truth truth{false, false};
    for (const AbstractValue& any : {any_number(), semantics::of_vacant()}) {
        const auto left = semantics::refine(any, known, earlier.right, zero);
        if (!left) continue;
        const Truth now = semantics::compare(later.operation, *left, later.right, zero);
        truth.can_hold |= now.can_hold;
        truth.can_fail |= now.can_fail;
    }
    return truth.can_hold == truth.can_fail ? std::nullopt : std::optional(truth.can_hold);
}

/// How the comparison turned out on every path from it to the node; nothing where it may be either, is but a
/// part of a condition, or where `nodes_left` to look at are too few.
std::optional<bool> outcome_on_the_way(const ProgramAnalysis& analysis, const Comparison& comparison,
                                       flow::NodeId node, std::size_t& nodes_left) {
    const Budget own = Budget::without_bound(); // it has a bound of its own
    Truth outcome{false, false};
    flow::walk<flow::Direction::backward>(analysis.graph(), {node}, [&](flow::EdgeId id, flow::NodeId from) {
        if (nodes_left == 0 || !analysis.data().passable(id)) return flow::Step::refuse;
        --nodes_left;
        if (from != comparison.node) return flow::Step::go_on;
        const flow::Edge& edge = analysis.graph().edges[id];
        const bool is_all = edge.condition == comparison.expression;
        outcome.can_hold |= !is_all || edge.holds;
        outcome.can_fail |= !is_all || !edge.holds;
        return flow::Step::refuse; // the other edge may lead here, too
    });
    if (nodes_left == 0 || outcome.can_hold == outcome.can_fail) return std::nullopt;
    return outcome.can_hold;
}

/// Where the program comes from to a node.
struct Before {
    flow::NodeId node;
    bool by_failed_guard; ///< the node is a condition, and that it was false is the only way on
};

class Row {
  public:
    Row(const ProgramAnalysis& analysis, const dataflow::Condition& last)
        : analysis_(analysis)
        , last_(last) {}

    std::optional<GuardBefore> find() {
        if (guard_in(last_.node) == nullptr) return std::nullopt;
        flow::NodeId node = last_.node;
        for (int i = 0; i < most_nodes; ++i) {
            const auto before = before_node(node);
            if (!before || !leaves_operands_alone(before->node)) return std::nullopt;
            node = before->node;
            const Guarded* guard = guard_in(node);
            if (guard == nullptr || !before->by_failed_guard) continue;
            if (!reads().closed) return std::nullopt;
            if (const auto makes = decides(node, guard->condition, last_.expression))
                return GuardBefore{analysis_.graph().nodes[node].effects.first, guard->condition,
                                   same_expression(program(), guard->condition, last_.expression), *makes};
        }
        return std::nullopt;
    }

  private:
    [[nodiscard]] const Program& program() const { return analysis_.program(); }

    [[nodiscard]] const Guarded* guard_in(flow::NodeId node) const {
        const Slice effects = analysis_.graph().nodes[node].effects;
        return effects.count == 1 ? std::get_if<Guarded>(&program().effects[effects.first].what) : nullptr;
    }

    /// What the last condition reads; few rows get so far.
    [[nodiscard]] const dataflow::ReadSet& reads() {
        if (!reads_) reads_ = dataflow::variables_of(program(), last_.expression);
        return *reads_;
    }

    /// Edges by which the program comes to a node; of more than two no more matter.
    struct EdgesTo {
        std::array<const flow::Edge*, 3> edges{};
        std::size_t count = 0;
    };
    [[nodiscard]] EdgesTo edges_to(flow::NodeId node) const {
        EdgesTo to;
        for (const flow::EdgeId id : analysis_.graph().in[node]) {
            if (!analysis_.data().passable(id)) continue;
            to.edges[to.count++] = &analysis_.graph().edges[id];
            if (to.count == to.edges.size()) break;
        }
        return to;
    }

    /// The one node that leads to another; that of a guard where what it guards leads there as well.
    [[nodiscard]] std::optional<Before> before_node(flow::NodeId node) {
        const auto [edges, count] = edges_to(node);
        if (count == 1 && edges[0]->kind != flow::EdgeKind::jump)
            return Before{edges[0]->from, is_failed(*edges[0])};
        if (count != 2 || is_failed(*edges[0]) == is_failed(*edges[1])) return std::nullopt;
        const flow::NodeId guard = edges[is_failed(*edges[0]) ? 0 : 1]->from;
        const flow::NodeId guarded = edges[is_failed(*edges[0]) ? 1 : 0]->from;
        const auto to_guarded = edges_to(guarded);
        if (to_guarded.count != 1 || to_guarded.edges[0]->from != guard || !leaves_operands_alone(guarded))
            return std::nullopt;
        return Before{guard, false};
    }

    static bool is_failed(const flow::Edge& edge) { return edge.condition.has_value() && !edge.holds; }

    /// Whether the node guards, or stores in variables that the last condition does not read, and no more.
    [[nodiscard]] bool leaves_operands_alone(flow::NodeId at) {
        const flow::Node& node = analysis_.graph().nodes[at];
        if (node.is_run) return false;
        return std::ranges::all_of(program().effects_in(node.effects), [&](const Effect& effect) {
            if (std::holds_alternative<Guarded>(effect.what)) return true;
            const auto* assign = std::get_if<Assign>(&effect.what);
            const auto* variable = assign == nullptr ? nullptr : std::get_if<Variable>(&assign->target);
            return variable != nullptr &&
                   std::ranges::find(reads().variables, *variable) == reads().variables.end();
        });
    }

    /// What `later` always is when `earlier`, in this node, is false.
    [[nodiscard]] std::optional<bool> decides(flow::NodeId node, ExpressionId earlier,
                                              ExpressionId later) const {
        if (same_expression(program(), earlier, later)) return false;
        const Comparison* first = comparison_with_number(node, earlier);
        const Comparison* second = comparison_with_number(last_.node, later);
        if (first == nullptr || second == nullptr) return std::nullopt;
        return outcome_after(analysis_, *first, false, *second);
    }

    /// The comparison that a condition is, where its right side is a number of the text; else nullptr.
    [[nodiscard]] const Comparison* comparison_with_number(flow::NodeId node, ExpressionId condition) const {
        for (const Comparison& comparison : analysis_.facts().in<Comparison>(node))
            if (comparison.expression == condition && has_number_on_right(program(), comparison))
                return &comparison;
        return nullptr;
    }

    const ProgramAnalysis& analysis_;
    const dataflow::Condition& last_;
    std::optional<dataflow::ReadSet> reads_;
};

bool is_used_as_given(const ProgramAnalysis& analysis, const dataflow::Read& read) {
    using dataflow::Use;
    const dataflow::Symbol& symbol = analysis.data().table().symbols[read.value.symbol];
    return (read.use == Use::word || read.use == Use::arithmetic) &&
           symbol.is_entry_of(dataflow::key_of(read.variable)) &&
           analysis.control().letter_of(read.variable).has_value();
}

} // namespace

std::optional<GuardBefore> guard_that_decides(const ProgramAnalysis& analysis,
                                              const dataflow::Condition& condition) {
    return Row(analysis, condition).find();
}

bool decides(const ProgramAnalysis& analysis, const Comparison& earlier, const dataflow::Condition& condition,
             std::size_t& nodes_left) {
    if (!has_number_on_right(analysis.program(), earlier)) return false;
    std::optional<std::optional<bool>> outcome; // nothing: nobody has asked
    for (const Comparison& later : analysis.facts().at<Comparison>(condition.effect)) {
        if (later.truth.can_hold == later.truth.can_fail || !has_number_on_right(analysis.program(), later))
            continue;
        for (const bool holds : {true, false}) {
            if (outcome_after(analysis, earlier, holds, later) != later.truth.can_hold) continue;
            if (!outcome) outcome = outcome_on_the_way(analysis, earlier, condition.node, nodes_left);
            if (*outcome == holds) return true;
        }
    }
    return false;
}

std::vector<Variable> untested_arguments(const ProgramAnalysis& analysis) {
    std::vector<Variable> untested;
    if (!analysis.is_macro()) return untested;
    for (const dataflow::Read& read : analysis.facts().all<dataflow::Read>())
        if (is_used_as_given(analysis, read)) untested.push_back(read.variable);
    std::ranges::sort(untested, {}, &Variable::number);
    const auto again = std::ranges::unique(untested);
    untested.erase(again.begin(), again.end()); // then there are no more than letters
    for (const Comparison& comparison : analysis.facts().all<Comparison>())
        for (const ExpressionId side : {comparison.left_expression, comparison.right_expression})
            std::erase(untested, plain_variable(analysis.program(), side));
    return untested;
}

} // namespace maclint::queries
