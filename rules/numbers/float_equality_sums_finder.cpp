//! Looks through the stores of all loops.
#include "rules/numbers/float_equality_sums_finder.hpp"

#include "analyzer/queries/conditions/conditions.hpp"

#include <algorithm>

namespace maclint::rules {

Sums find_sums(const ProgramAnalysis& analysis) {
    std::vector<bool> repeated(analysis.graph().nodes.size(), false);
    for (const dataflow::Loop& loop : analysis.loops())
        for (const flow::NodeId node : loop.body) repeated[node] = true;
    Sums sums;
    for (const dataflow::Store& store : analysis.facts().all<dataflow::Store>()) {
        if (!store.step || !repeated[store.node]) continue;
        const dataflow::Value& amount = store.step->amount;
        if (amount.integer || (amount.constant() && !dataflow::is_inexact(amount))) continue;
        const auto same = [&](const dataflow::Store* other) { return other->variable == store.variable; };
        if (std::ranges::none_of(sums, same)) sums.push_back(&store);
    }
    return sums;
}

const dataflow::Store* sum_in(const ProgramAnalysis& analysis, const Sums& sums, ExpressionId expression) {
    const auto variable = queries::plain_variable(analysis.program(), expression);
    if (!variable) return nullptr;
    const auto found =
        std::ranges::find_if(sums, [&](const dataflow::Store* sum) { return sum->variable == *variable; });
    return found == sums.end() ? nullptr : *found;
}

} // namespace maclint::rules
