//! The loops of a program as they run: WHILE and DO as well as cycles closed by a jump, with what they change
//! and how they end.
#pragma once

#include "analyzer/dataflow/analysis.hpp"
#include "analyzer/dataflow/conditions.hpp"
#include "analyzer/flow/structure.hpp"

#include <optional>
#include <vector>

namespace maclint::dataflow {

struct Loop {
    flow::NodeId head;  ///< where every round begins
    flow::NodeId latch; ///< the node that leads back to it
    flow::EdgeId back;
    std::optional<flow::StructureId> structure; ///< WHILE or DO; empty: closed by a jump
    std::vector<flow::NodeId> body;             ///< sorted, head and latch included
    std::vector<flow::EdgeId> ways_out; ///< edges that leave the body, also those that are never taken
    bool can_stop; ///< a return, program end, alarm or pause is inside, or in a program called there
    bool has_unknown_effects; ///< a call of an unknown program or an unreadable block is inside

    [[nodiscard]] bool holds(flow::NodeId node) const;
};

/// All loops that can be reached, in text order of their heads. A program with so many nested cycles that
/// listing them would take more than a fixed amount of work gets only the first of them.
[[nodiscard]] std::vector<Loop> find_loops(const Program& program, const flow::Structures& structures,
                                           const flow::Graph& graph, const Analysis& analysis);

/// Cycles that nothing ends: no way leads out of them, and nothing in them stops the program. The body is all
/// that can be reached from inside; `structure` is the outermost WHILE or DO that holds all of it, if one
/// does, else `back` is the last jump back in the text.
[[nodiscard]] std::vector<Loop> find_traps(const Program& program, const flow::Structures& structures,
                                           const flow::Graph& graph, const Analysis& analysis);

/// The assignments in the loop's body that change the variable.
[[nodiscard]] std::vector<const Store*> stores_in(const Loop& loop, const Facts& facts, Place place);
/// Every variable that the loop's body may change, in whatever way.
class LoopChanges {
  public:
    LoopChanges(const Loop& loop, const Facts& facts);
    [[nodiscard]] bool may_change(Place place) const { return assigned(place) || disturbed(place); }
    /// By something that is no assignment: a call, a store through an index.
    [[nodiscard]] bool disturbed(Place place) const;

  private:
    [[nodiscard]] bool assigned(Place place) const;
    std::vector<Key> assigned_, disturbed_; ///< sorted
    std::vector<SpaceId> spaces_;           ///< of which anything may change
};

/// One way out of a loop that a counter decides.
struct CounterTest {
    const Comparison* comparison;
    Operation stays;    ///< the loop goes on as long as counter `stays` bound: less for WHILE[#1LT10]
    ExpressionId bound; ///< does not change in the loop
    const Value* bound_value;
};

/// A variable that alone decides when a loop ends.
struct Counter {
    Place place;
    std::vector<CounterTest> tests;   ///< one for every way out, at least one
    std::vector<const Store*> steps;  ///< v = v + amount, at least one
    std::vector<const Store*> clamps; ///< other assignments, each guarded by a condition on the variable
};

/// The counter of the loop; nothing when something else has a say in its end.
[[nodiscard]] std::optional<Counter> counter_of(const Program& program, const flow::Graph& graph,
                                                const Facts& facts, const Loop& loop);

} // namespace maclint::dataflow
