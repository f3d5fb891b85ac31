//! The loops of a program as they run: WHILE and DO as well as cycles closed by a jump, with what they change
//! and how they end.
#pragma once

#include "analyzer/dataflow/cycles.hpp"
#include "analyzer/dataflow/loop_changes.hpp"
#include "analyzer/dataflow/solver/analysis.hpp"
#include "analyzer/flow/regions.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

namespace maclint::dataflow {

struct Loop {
    flow::NodeId head = 0;  ///< where every round begins
    flow::NodeId latch = 0; ///< the node that leads back to it
    flow::EdgeId back = 0;
    std::optional<flow::RegionId> region; ///< WHILE or DO; empty: closed by a jump
    std::vector<flow::NodeId> body;       ///< sorted, head and latch included
    std::vector<flow::EdgeId> exit_edges; ///< edges that leave the body, also those that are never taken
    bool can_stop = false; ///< a return, program end, alarm or pause is inside, or in a program called there
    bool has_unknown_effects = false; ///< a call of an unknown program or an unreadable block is inside
    LoopChanges changes;

    [[nodiscard]] bool holds(flow::NodeId node) const;
};

/// All loops that can be reached, in text order of their heads. A program with so many nested cycles that
/// listing them would take more than a fixed amount of work gets only the first of them.
[[nodiscard]] std::vector<Loop> find_loops(const Program& program, const flow::Regions& regions,
                                           const flow::Graph& graph, const Analysis& analysis,
                                           const Cycles& cycles);

/// Cycles that nothing ends: no path leads out of them, and nothing in them stops the program. The body is
/// all that can be reached from inside; `region` is the outermost WHILE or DO that holds all of it, if one
/// does, else `back` is the last jump back in the text. What they change is not looked at.
[[nodiscard]] std::vector<Loop> find_inescapable_cycles(const Program& program, const flow::Regions& regions,
                                                        const flow::Graph& graph, const Analysis& analysis,
                                                        const Cycles& cycles);

/// Calls `visit` for every fact in the loop's body. Facts and body are both in the order of nodes, so the
/// facts of each node are looked up behind those of the node before.
template<class Fact, class Visit>
void for_each_in_body(const Loop& loop, std::span<const Fact> facts, const Visit& visit) {
    auto fact = facts.begin();
    for (const flow::NodeId node : loop.body) {
        constexpr int usually_enough = 4;
        for (int i = 0; i < usually_enough && fact != facts.end() && fact->node < node; ++i) ++fact;
        if (fact != facts.end() && fact->node < node)
            fact = std::ranges::lower_bound(fact, facts.end(), node, {}, &Fact::node);
        for (; fact != facts.end() && fact->node == node; ++fact) visit(*fact);
        if (fact == facts.end()) return;
    }
}

} // namespace maclint::dataflow
