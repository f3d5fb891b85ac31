//! States of variables and modal groups as what is solved along the paths of a graph.
#pragma once

#include "analyzer/dataflow/domain/state.hpp"
#include "analyzer/dataflow/solver/transfer.hpp"
#include "analyzer/flow/graph.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace maclint::dataflow {

class StateDomain {
  public:
    using State = dataflow::State;

    StateDomain(const Program& program, States& states, Transfer& transfer);

    [[nodiscard]] State at_begin(flow::NodeId node) const { return node == 0 ? states_.at_entry() : State{}; }
    [[nodiscard]] static bool is_reached(const State& state) { return state.reached; }
    [[nodiscard]] bool equal(const State& a, const State& b) const { return states_.equal(a, b); }
    [[nodiscard]] State join(const State& a, const State& b, flow::NodeId node) {
        return states_.join(a, b, node);
    }
    [[nodiscard]] State run(flow::NodeId node, const State& state) { return transfer_.run(node, state); }
    [[nodiscard]] State along(const flow::Edge& edge, const State& after) {
        return transfer_.along(edge, after);
    }
    /// The bounds of numbers at a loop's head; elsewhere the old state is kept in the join.
    [[nodiscard]] static bool widens(bool is_head, std::uint32_t visit);
    [[nodiscard]] State widen(flow::NodeId node, bool is_head, std::uint32_t visit, const State& old,
                              const State& incoming);

  private:
    States& states_;
    Transfer& transfer_;
    std::vector<double> thresholds_;
};

} // namespace maclint::dataflow
