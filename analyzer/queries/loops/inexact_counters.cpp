//! Which loop counters are inexact, and when that is of no consequence.
#include "analyzer/queries/loops/inexact_counters.hpp"

#include "analyzer/queries/paths/feasible_paths.hpp"
#include "analyzer/queries/values/calculations.hpp"

#include <algorithm>
#include <cmath>

namespace maclint::queries {
namespace {

/// A step of 0.1, or one that came out of a division.
bool is_inexact_step(const ProgramAnalysis& analysis, const dataflow::Value& amount) {
    if (!dataflow::is_inexact(amount)) return false;
    if (amount.constant()) return true;
    return operation_of(analysis, amount) == Operation::divide;
}

/// The numbers that the counter can have before the loop, as far as they are known.
std::vector<double> starts_of(const ProgramAnalysis& analysis, const dataflow::Loop& loop,
                              Variable variable) {
    std::vector<double> starts;
    for (const dataflow::Store* store : last_stores_before(analysis, variable, loop))
        if (const auto number = store->value.constant()) starts.push_back(*number);
    if (starts.empty()) starts.push_back(0);
    return starts;
}

/// The bound stands between two steps, so that no error can reach it: WHILE[#1LT1.05] with steps of 0.1, and
/// 9.9999 as well, as long as they are not too many.
bool has_room(double bound, double start, double step) {
    const double steps = (bound - start) / step;
    constexpr double rounding = 5e-8; // of one sum, times its size: half of the last of eight digits
    constexpr double most_room = 0.25;
    const double error = std::abs(steps) * rounding * std::max(std::abs(bound), std::abs(start));
    return std::abs(steps - std::round(steps)) > std::min(error / std::abs(step), most_room);
}

/// [#2+0.001]: somebody thought of it. What is no part of a step is no tolerance.
bool adds_tolerance(const Program& program, ExpressionId bound, double step) {
    const auto* apply = std::get_if<Apply>(&program.expressions[bound].node);
    if (apply == nullptr || (apply->operation != Operation::add && apply->operation != Operation::subtract))
        return false;
    return std::ranges::any_of(program.operands_of(*apply), [&](ExpressionId operand) {
        const auto* literal = std::get_if<Literal>(&program.expressions[operand].node);
        return literal != nullptr && literal->value != 0 && std::abs(literal->value) < step;
    });
}

/// Whether an error in the counter can decide for another pass or against it.
bool is_risky(const ProgramAnalysis& analysis, const dataflow::Loop& loop, const Counter& counter,
              const CounterTest& test) {
    if (test.stays == Operation::equal) return false; // ends after a round, whatever the counter is
    if (test.stays == Operation::not_equal) return true;
    const auto step = counter.steps.front()->step->amount.constant();
    constexpr double usual_step = 1; // of one that only the running program knows
    if (exemptions::tolerance_in_the_bound.is_on() &&
        adds_tolerance(analysis.program(), test.bound, step ? std::abs(*step) : usual_step))
        return false;
    const auto bound = test.bound_value->constant();
    if (!bound || !step || *step == 0) return true;
    return !std::ranges::all_of(starts_of(analysis, loop, counter.variable),
                                [&](double start) { return has_room(*bound, start, *step); });
}

const CounterTest* decisive_test(const ProgramAnalysis& analysis, const dataflow::Loop& loop,
                                 const Counter& counter) {
    const auto found = std::ranges::find_if(
        counter.tests, [&](const CounterTest& test) { return is_risky(analysis, loop, counter, test); });
    return found == counter.tests.end() ? nullptr : &*found;
}

} // namespace

std::vector<InexactCounter> find_inexact_counters(const ProgramAnalysis& analysis) {
    std::vector<InexactCounter> found;
    std::unordered_set<const dataflow::Store*> steps;
    const auto look_at = [&](const dataflow::Loop& loop, const Counter& counter) {
        if (exemptions::counter_held_at_a_limit.is_on() && !counter.clamps.empty()) return;
        const auto inexact = std::ranges::find_if(counter.steps, [&](const dataflow::Store* store) {
            return is_inexact_step(analysis, store->step->amount);
        });
        if (inexact == counter.steps.end()) return;
        const CounterTest* decisive = decisive_test(analysis, loop, counter);
        if (decisive == nullptr || !steps.insert(*inexact).second) return;
        InexactCounter one{*inexact, *decisive, {}};
        for (const CounterTest& test : counter.tests) one.tests.push_back(test.comparison);
        found.push_back(std::move(one));
    };
    for (const dataflow::Loop& loop : analysis.loops())
        for (const Counter& counter : counters_of(analysis, loop)) look_at(loop, counter);
    return found;
}

std::unordered_set<const dataflow::Comparison*> tests_of(const std::vector<InexactCounter>& counters) {
    std::unordered_set<const dataflow::Comparison*> tests;
    for (const InexactCounter& counter : counters) tests.insert(counter.tests.begin(), counter.tests.end());
    return tests;
}

} // namespace maclint::queries
