//! Which values may still be read: what is not is a store that nobody needs.
#pragma once

#include "analyzer/dataflow/domain/small_vector.hpp"
#include "analyzer/flow/graph.hpp"
#include "analyzer/program/model.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace maclint::dataflow {

/// Variables whose value may be read before it is replaced. No words at all: no path leads here.
using LiveSet = SmallVector<std::uint64_t, 2>; // a VariableSet, whose header few readers need

class LiveVariables;

class Liveness {
  public:
    /// What becomes of the local variables when the program has returned: a caller that shares them reads
    /// them.
    enum class Locals : std::uint8_t { end_with_it, outlive_it };

    /// Solves at once, unless blocks and variables are too many to keep all of both. The references must
    /// outlive the liveness.
    Liveness(const Program& program, const flow::Graph& graph, Locals locals);
    Liveness(Liveness&&) noexcept;
    Liveness& operator=(Liveness&&) noexcept;
    ~Liveness();

    /// Whether it was solved.
    [[nodiscard]] bool is_known() const { return is_known_; }
    /// Whether what the variable holds after the effect may be read: here, by a called program, or when this
    /// one has ended. True where nothing is known, as of a variable that the program does not name.
    [[nodiscard]] bool is_live_after(EffectId effect, Variable variable) const;
    /// The variables that the program names and whose value before the node may be read.
    [[nodiscard]] std::vector<Variable> live_before(flow::NodeId node) const;

  private:
    [[nodiscard]] LiveSet after(flow::NodeId node) const;

    const flow::Graph* graph_;
    std::unique_ptr<const LiveVariables> variables_;
    bool is_known_ = false;
    std::size_t words_ = 0;            ///< of a set
    std::vector<std::uint64_t> after_; ///< the sets of all nodes, one after the other
};

} // namespace maclint::dataflow
