//! Compares the sign of a step with the comparisons that end the loop.
#include "analyzer/queries/loops/loop_steps.hpp"

#include "analyzer/queries/vacancy/unset_reads.hpp"

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace maclint::queries {
namespace {

/// Whether the step moves the counter to where the loop goes on.
bool leads_away(const Counter& counter, const dataflow::Step& step, double amount) {
    if (!counter.clamps.empty()) return false;
    const bool down = (step.operation == Operation::subtract) == (amount > 0);
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
    const auto constant = amount.constant();
    if (!constant) return StepFault::none;
    if (*constant == 0) return StepFault::zero;
    return leads_away(counter, step, *constant) ? StepFault::wrong_sign : StepFault::none;
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
    if (step.amount.constant() || !counter.clamps.empty()) return std::nullopt;
    return value_for_a_call(analysis, step.amount, [&](const PassedValue& passed) {
        return passed.number != 0 && !passed.left_out && step.amount.can_be(passed.number) &&
               leads_away(counter, step, passed.number);
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
