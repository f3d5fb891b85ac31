//! Goes through the loops that a counter ends.
#include "rules/variables/missing_argument_validation_finder.hpp"

#include "analyzer/queries/loops/loop_counter.hpp"

#include <algorithm>
#include <optional>

namespace maclint::rules {

namespace {

/// Another test ends the loop at a number: a search through a table, which asks whether it is at its end.
bool ends_at_a_number(const queries::Counter& counter) {
    return std::ranges::any_of(counter.tests, [](const queries::CounterTest& test) {
        return test.bound_value->constant() && test.stays != Operation::equal &&
               test.stays != Operation::not_equal;
    });
}

} // namespace

std::vector<UncheckedBound> unchecked_bounds(const ProgramAnalysis& analysis) {
    std::vector<UncheckedBound> found;
    std::optional<queries::OperandRisks> risks;
    for (const dataflow::Loop& loop : analysis.loops()) {
        const auto counter = queries::counter_of(analysis, loop);
        if (!counter || (exemptions::search_in_a_table.is_on() && ends_at_a_number(*counter))) continue;
        for (const queries::CounterTest& test : counter->tests) {
            const auto reads = analysis.facts().at<dataflow::Read>(test.comparison->effect);
            const auto read = std::ranges::find(reads, test.bound, &dataflow::Read::expression);
            if (read == reads.end()) continue;
            if (!risks) risks.emplace(analysis);
            const auto risk = risks->risk_of_argument(*read, counter->variable);
            const auto is_same = [&](const UncheckedBound& other) {
                return other.read->variable == read->variable;
            };
            if (risk && std::ranges::none_of(found, is_same))
                found.push_back({test.comparison, &*read, counter->variable, *risk});
        }
    }
    std::ranges::sort(found, {}, [](const UncheckedBound& bound) { return bound.test->effect; });
    return found;
}

} // namespace maclint::rules
