//! Which loop counters are inexact, and when that is of no consequence.
#include "rules/numbers/inexact_counter.hpp"

#include <algorithm>
#include <cmath>

namespace maclint::rules {
namespace {

/// A step of 0.1, or one that came out of a division.
bool is_inexact_step(const ProgramAnalysis& analysis, const dataflow::Value& amount) {
    if (!dataflow::is_inexact(amount)) return false;
    if (amount.constant()) return true;
    const dataflow::Symbol& symbol = analysis.data().pool().symbols[amount.symbol];
    return symbol.kind == dataflow::Symbol::Kind::result &&
           static_cast<Operation>(symbol.a) == Operation::divide;
}

/// The number that the counter has before the loop; 0 when it is not known.
double start_of(const ProgramAnalysis& analysis, const dataflow::Loop& loop, Place place) {
    for (const dataflow::Store& store : analysis.facts().stores)
        if (store.place == place && !loop.holds(store.node))
            if (const auto number = store.value.constant()) return *number;
    return 0;
}

/// The bound stands between two steps, so that no error can reach it: WHILE[#1LT1.05] with steps of 0.1.
bool has_room(const dataflow::CounterTest& test, double start, double step) {
    const auto bound = test.bound_value->constant();
    if (!bound || step == 0) return false;
    const double steps = (*bound - start) / step;
    constexpr double room = 0.01;
    return std::abs(steps - std::round(steps)) > room;
}

/// [#2+0.001]: somebody thought of it.
bool adds_tolerance(const Program& program, ExpressionId bound) {
    const auto* apply = std::get_if<Apply>(&program.expressions[bound].node);
    if (apply == nullptr || (apply->operation != Operation::add && apply->operation != Operation::subtract))
        return false;
    return std::ranges::any_of(program.operands_of(*apply), [&](ExpressionId operand) {
        const auto* literal = std::get_if<Literal>(&program.expressions[operand].node);
        return literal != nullptr && literal->value != 0 && std::abs(literal->value) < 1;
    });
}

bool is_risky(const ProgramAnalysis& analysis, const dataflow::Loop& loop, const dataflow::Counter& counter) {
    const double start = start_of(analysis, loop, counter.place);
    return std::ranges::any_of(counter.tests, [&](const dataflow::CounterTest& test) {
        if (adds_tolerance(analysis.program(), test.bound)) return false;
        const auto step = counter.steps.front()->step->amount.constant();
        return !step || !has_room(test, start, *step);
    });
}

} // namespace

std::vector<InexactCounter> find_inexact_counters(const ProgramAnalysis& analysis) {
    std::vector<InexactCounter> found;
    for (const dataflow::Loop& loop : analysis.loops()) {
        const auto& counter = loop.counter;
        if (!counter || !counter->clamps.empty()) continue;
        const auto inexact = std::ranges::find_if(counter->steps, [&](const dataflow::Store* store) {
            return is_inexact_step(analysis, store->step->amount);
        });
        if (inexact == counter->steps.end() || !is_risky(analysis, loop, *counter)) continue;
        if (std::ranges::find(found, *inexact, &InexactCounter::step) != found.end()) continue;
        InexactCounter one{*inexact, {}};
        for (const dataflow::CounterTest& test : counter->tests) one.tests.push_back(test.comparison);
        found.push_back(std::move(one));
    }
    return found;
}

bool decides(const std::vector<InexactCounter>& counters, const dataflow::Comparison& comparison) {
    return std::ranges::any_of(counters, [&](const InexactCounter& counter) {
        return std::ranges::find(counter.tests, &comparison) != counter.tests.end();
    });
}

} // namespace maclint::rules
