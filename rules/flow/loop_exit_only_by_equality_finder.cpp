//! Counts whether steps come to the bound.
#include "rules/flow/loop_exit_only_by_equality_finder.hpp"

#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/queries/paths/feasible_paths.hpp"
#include "analyzer/source/budget.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace maclint::rules {
namespace {

/// Whether a whole number of steps leads there, as near as the control calculates.
bool comes_to(double start, double step, double bound) {
    constexpr double rounding = 1e-6;
    const double steps = (bound - start) / step;
    return steps > -rounding && std::abs(steps - std::round(steps)) < rounding;
}

/// The variable of a call that the bound is, which the program itself never changes.
std::optional<Variable> argument_as_bound(const ProgramAnalysis& analysis, ExpressionId bound) {
    const Program& program = analysis.program();
    const auto* load = std::get_if<Load>(&program.expressions[bound].node);
    if (load == nullptr || !program.is_formal(load->variable)) return std::nullopt;
    const bool changes =
        std::ranges::any_of(analysis.facts().all<dataflow::Store>(),
                            [&](const dataflow::Store& store) { return store.variable == load->variable; });
    return changes ? std::nullopt : std::optional(load->variable);
}

/// The first call that passes a number to which no steps come.
std::optional<MissedBound> passed_number(const ProgramAnalysis& analysis, MissedBound missed,
                                         Variable bound) {
    for (const Caller& caller : analysis.callers()) {
        if (!Budget::allows()) return std::nullopt;
        const Argument* argument = queries::argument_for(analysis, caller, bound);
        if (argument == nullptr || !queries::opens_locals(analysis, caller)) continue;
        const Program& calling = queries::calling_program(analysis, caller).program();
        const auto* number = std::get_if<Literal>(&calling.expressions[argument->value].node);
        if (number == nullptr || comes_to(missed.start, missed.amount, number->value)) continue;
        missed.bound = number->value;
        missed.call = caller;
        return missed;
    }
    return std::nullopt;
}

std::optional<MissedBound> missed_bound(const ProgramAnalysis& analysis, const dataflow::Loop& loop,
                                        const queries::Counter& counter) {
    const bool by_equality = std::ranges::all_of(
        counter.tests, [](const queries::CounterTest& test) { return test.stays == Operation::not_equal; });
    if (!by_equality || counter.tests.size() != 1 || counter.steps.size() != 1 || !counter.clamps.empty())
        return std::nullopt;
    const dataflow::Store& step = *counter.steps.front();
    const auto amount = step.step->amount.constant();
    const auto starts = queries::last_stores_before(analysis, counter.variable, loop);
    if (!amount || *amount == 0 || starts.size() != 1) return std::nullopt;
    const auto start = starts.front()->value.constant();
    if (!start) return std::nullopt;
    const double by = step.step->operation == Operation::subtract ? -*amount : *amount;
    const queries::CounterTest& test = counter.tests.front();
    MissedBound missed{&loop, &step, test.comparison, *start, by, 0, std::nullopt};
    if (const auto bound = test.bound_value->constant()) {
        missed.bound = *bound;
        return comes_to(*start, by, *bound) ? std::nullopt : std::optional(missed);
    }
    const auto argument = argument_as_bound(analysis, test.bound);
    return argument ? passed_number(analysis, missed, *argument) : std::nullopt;
}

} // namespace

std::vector<MissedBound> find_missed_bounds(const ProgramAnalysis& analysis) {
    std::vector<MissedBound> found;
    for (const dataflow::Loop& loop : analysis.loops())
        if (const auto counter = queries::counter_of(analysis, loop))
            if (const auto missed = missed_bound(analysis, loop, *counter)) found.push_back(*missed);
    return found;
}

} // namespace maclint::rules
