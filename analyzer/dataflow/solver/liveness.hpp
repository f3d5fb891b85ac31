//! Which values may still be read: what is not is a store that nobody needs.
#pragma once

#include "analyzer/dataflow/domain/small_vector.hpp"
#include "analyzer/dataflow/solver/summary.hpp"
#include "analyzer/flow/graph.hpp"
#include "analyzer/program/model.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace maclint::dataflow {

/// Variables of a program whose value may be read before it is replaced, as bits: bit n is the n-th that the
/// program names. No words at all: no path leads here.
using LiveSet = SmallVector<std::uint64_t, 2>;

class LiveVariables;

class Liveness {
  public:
    /// What becomes of the local variables when the program has returned: a caller that shares them reads
    /// them.
    enum class Locals : std::uint8_t { end_with_it, outlive_it };

    /// Solves at once. The references must outlive the liveness.
    Liveness(const Program& program, const flow::Graph& graph, Locals locals);
    /// Of this program's decisions alone, on paths to the goal: only what a condition, the target of a jump
    /// or a call that may not come back depends on is read. From elsewhere nothing is.
    [[nodiscard]] static Liveness of_decisions(const Program& program, const flow::Graph& graph,
                                               const Callees& callees, flow::NodeId goal);
    Liveness(Liveness&&) noexcept;
    Liveness& operator=(Liveness&&) noexcept;
    ~Liveness();

    /// Whether what the variable holds after the effect may be read: here, by a called program, or when this
    /// one has ended. True where nothing is known, as of a variable that the program does not name.
    [[nodiscard]] bool is_live_after(EffectId effect, Variable variable) const;
    /// The variables that the program names and whose value before the node may be read; none where no path
    /// leads to the goal.
    [[nodiscard]] std::vector<Variable> live_before(flow::NodeId node) const;

  private:
    Liveness(const flow::Graph& graph, std::unique_ptr<const LiveVariables> variables);

    const flow::Graph* graph_;
    std::unique_ptr<const LiveVariables> variables_;
    std::vector<LiveSet> after_; ///< every node
};

} // namespace maclint::dataflow
