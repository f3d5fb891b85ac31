//! The variable that counts the rounds of a loop.
#pragma once

#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/dataflow/loops.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>
#include <vector>

namespace maclint::queries {

/// One exit of a loop that a counter decides. Pointers lead to facts of the program.
struct CounterTest {
    const dataflow::Comparison* comparison;
    Operation stays;    ///< the loop goes on as long as counter `stays` bound: less for WHILE[#1LT10]
    ExpressionId bound; ///< does not change in the loop
    const dataflow::Value* bound_value;
};

/// A variable that decides when a loop ends.
struct Counter {
    Variable variable;
    std::vector<CounterTest> tests;            ///< one for every exit that it decides, at least one
    std::vector<const dataflow::Store*> steps; ///< v = v + amount, at least one
    std::vector<const dataflow::Store*>
        clamps; ///< other assignments, each guarded by a condition on the variable
};

/// The counter of one of the program's loops; nothing when something else has a say in the loop's end.
[[nodiscard]] std::optional<Counter> counter_of(const ProgramAnalysis& analysis, const dataflow::Loop& loop);

/// Variables by each of which the loop may end, whatever else ends it and whatever a called program may do to
/// them.
[[nodiscard]] std::vector<Counter> counters_of(const ProgramAnalysis& analysis, const dataflow::Loop& loop);

} // namespace maclint::queries
