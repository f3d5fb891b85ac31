//! What a loop changes, and the variable that counts its rounds.
#pragma once

#include "analyzer/dataflow/facts.hpp"
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/dataflow/state.hpp"

#include <optional>
#include <vector>

namespace maclint::dataflow {

struct Loop;

/// Every variable that a loop's body may change, in whatever way.
class LoopChanges {
  public:
    LoopChanges() = default;
    LoopChanges(const Loop& loop, const Facts& facts);
    [[nodiscard]] bool may_change(Variable variable) const {
        return assigned(variable) || clobbered(variable);
    }
    /// By something that is no assignment: a call, a store through an index.
    [[nodiscard]] bool clobbered(Variable variable) const;

  private:
    [[nodiscard]] bool assigned(Variable variable) const;
    std::vector<Key> assigned_, clobbered_; ///< sorted
    std::vector<SpaceId> spaces_;           ///< of which anything may change
};

/// One exit of a loop that a counter decides.
struct CounterTest {
    const Comparison* comparison;
    Operation stays;    ///< the loop goes on as long as counter `stays` bound: less for WHILE[#1LT10]
    ExpressionId bound; ///< does not change in the loop
    const Value* bound_value;
};

/// A variable that alone decides when a loop ends.
struct Counter {
    Variable variable;
    std::vector<CounterTest> tests;   ///< one for every exit, at least one
    std::vector<const Store*> steps;  ///< v = v + amount, at least one
    std::vector<const Store*> clamps; ///< other assignments, each guarded by a condition on the variable
};

/// The counter of a loop whose changes are known.
[[nodiscard]] std::optional<Counter> counter_of(const Program& program, const flow::Graph& graph,
                                                const Facts& facts, const Loop& loop);

} // namespace maclint::dataflow
