//! Whether a call ends a loop around it by an alarm.
#pragma once

#include "analyzer/dataflow/domain/state.hpp"
#include "analyzer/dataflow/facts/call_made.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/dataflow/loops.hpp"
#include "analyzer/dataflow/solver/analysis.hpp"

#include <map>
#include <optional>
#include <tuple>
#include <vector>

namespace maclint::dataflow {

/// The calls of one loop, each of which may be asked about.
class LoopStops {
  public:
    /// The references must outlive it.
    LoopStops(const Program& program, const flow::Graph& graph, const Analysis& analysis, const Loop& loop)
        : program_(program)
        , graph_(graph)
        , analysis_(analysis)
        , loop_(loop) {}

    /// Whether the called program may stop in some later round of the loop, though not in the first. It may
    /// where the first round may do without the call, or where what decides over the stop is unknown, read
    /// from the machine, or changed by the loop or by what it calls. Also true where too much would have to
    /// be looked at.
    [[nodiscard]] bool may_stop_later(const CallMade& made);

  private:
    static constexpr int most_assignments = 8; ///< one made of another

    [[nodiscard]] bool is_made_in_each_round(const CallMade& made, const Call& call);
    [[nodiscard]] std::vector<flow::NodeId> nodes_in_each_round() const;
    [[nodiscard]] bool passes_other_numbers(const CallMade& made, Variable variable);
    [[nodiscard]] bool differs(ExpressionId expression, flow::NodeId at, int left);
    [[nodiscard]] bool differs(Variable variable, flow::NodeId at, int left);
    [[nodiscard]] bool is_made_of_others(Variable variable, flow::NodeId at, int left);
    [[nodiscard]] bool is_always_made(const Store& store, flow::NodeId at);
    /// The place of one of its nodes in the loop's body.
    [[nodiscard]] std::size_t in_body(flow::NodeId node) const;
    [[nodiscard]] bool comes_before(flow::NodeId node, flow::NodeId last);

    const Program& program_;
    const flow::Graph& graph_;
    const Analysis& analysis_;
    const Loop& loop_;
    std::map<std::tuple<Key, flow::NodeId, int>, bool> differs_; ///< as far as it was asked
    std::optional<std::vector<flow::NodeId>> in_each_round_;     ///< see nodes_in_each_round; when asked for
    std::map<flow::NodeId, std::vector<bool>>
        before_; ///< nodes of the body that a round may come to before each
};

} // namespace maclint::dataflow
