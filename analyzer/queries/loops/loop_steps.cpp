//! Compares the sign of a step with the comparisons that end the loop.
#include "analyzer/queries/loops/loop_steps.hpp"

#include "analyzer/dataflow/domain/arithmetic.hpp"
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/queries/conditions/conditions.hpp"
#include "analyzer/queries/vacancy/unset_reads.hpp"

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace maclint::queries {
namespace {

/// Whether the clamp waits for the counter to be beyond the bound, on the side where the loop ends: it never
/// is while each step leads away. `IF[#32GE#26]GOTO10`, `#32=#26` in a loop that goes on while #32GT#26.
bool waits_for_the_end(const ProgramAnalysis& analysis, const Counter& counter,
                       const dataflow::Store& clamp) {
    const Program& program = analysis.program();
    const flow::Graph& graph = analysis.graph();
    const CounterTest& test = counter.tests.front();
    const auto is_counter = [&](ExpressionId id) {
        const auto* load = std::get_if<Load>(&program.expressions[id].node);
        return load != nullptr && load->variable == counter.variable;
    };
    return std::ranges::all_of(graph.in[clamp.node], [&](flow::EdgeId id) {
        const flow::Edge& edge = graph.edges[id];
        const auto comparisons = analysis.facts().in<dataflow::Comparison>(edge.from);
        const auto asked = std::ranges::find_if(comparisons, [&](const dataflow::Comparison& comparison) {
            return edge.condition == comparison.expression;
        });
        if (asked == comparisons.end() || !dataflow::is_comparison(asked->operation)) return false;
        Operation leads_there = edge.holds ? asked->operation : dataflow::opposite(asked->operation);
        ExpressionId bound = asked->right_expression;
        if (!is_counter(asked->left_expression)) {
            if (!is_counter(asked->right_expression)) return false;
            bound = asked->left_expression;
            leads_there = dataflow::mirrored(leads_there);
        }
        const bool is_above = test.stays == Operation::greater || test.stays == Operation::greater_equal;
        return same_expression(program, bound, test.bound) &&
               leads_there == (is_above ? Operation::less : Operation::greater);
    });
}

/// Whether the step moves the counter to where the loop goes on.
bool leads_away(const ProgramAnalysis& analysis, const Counter& counter, const dataflow::Step& step,
                bool is_positive) {
    if (!std::ranges::all_of(counter.clamps, [&](const dataflow::Store* clamp) {
            return waits_for_the_end(analysis, counter, *clamp);
        }))
        return false;
    const bool down = (step.operation == Operation::subtract) == is_positive;
    return std::ranges::all_of(counter.tests, [down](const CounterTest& test) {
        const bool below = test.stays == Operation::less || test.stays == Operation::less_equal;
        const bool above = test.stays == Operation::greater || test.stays == Operation::greater_equal;
        return down ? below : above;
    });
}

StepFault fault_of(const ProgramAnalysis& analysis, const Counter& counter, const dataflow::Step& step) {
    const dataflow::Value& amount = step.amount;
    if (call_that_leads_away(analysis, counter, step)) return StepFault::wrong_sign_passed;
    if (amount.vacancy_origin != 0 && amount.can_be(0))
        return is_owed_to_unset_variable(analysis, amount) ? StepFault::none : StepFault::vacant;
    if (amount.constant() == 0.0) return StepFault::zero;
    const bool has_sign = !amount.can_be(0) && (amount.low >= 0 || amount.high <= 0);
    return has_sign && leads_away(analysis, counter, step, amount.low >= 0) ? StepFault::wrong_sign
                                                                            : StepFault::none;
}

/// The fault of the first step when all have one.
StepFault fault_of_all(const ProgramAnalysis& analysis, const Counter& counter) {
    const auto fault = [&](const dataflow::Store* store) {
        return fault_of(analysis, counter, *store->step);
    };
    const bool one_is_right = std::ranges::find(counter.steps, StepFault::none, fault) != counter.steps.end();
    return one_is_right ? StepFault::none : fault(counter.steps.front());
}

} // namespace

std::optional<PassedValue> call_that_leads_away(const ProgramAnalysis& analysis, const Counter& counter,
                                                const dataflow::Step& step) {
    if (step.amount.constant()) return std::nullopt;
    return value_for_a_call(analysis, step.amount, [&](const PassedValue& passed) {
        return passed.number != 0 && !passed.left_out && step.amount.can_be(passed.number) &&
               leads_away(analysis, counter, step, passed.number > 0);
    });
}

std::vector<EndlessCounter> find_endless_counters(const ProgramAnalysis& analysis) {
    std::vector<EndlessCounter> found;
    std::unordered_set<EffectId> first_steps; // loops that share theirs have one cause
    for (const dataflow::Loop& loop : analysis.loops()) {
        if (loop.can_stop || loop.has_unknown_effects) continue;
        auto counter = counter_of(analysis, loop);
        const StepFault fault = counter ? fault_of_all(analysis, *counter) : StepFault::none;
        if (fault != StepFault::none && first_steps.insert(counter->steps.front()->effect).second)
            found.push_back({std::move(*counter), fault});
    }
    return found;
}

} // namespace maclint::queries
