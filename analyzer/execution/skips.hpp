//! What a path says of the switches for skipped blocks. The operator leaves a switch as it is during a run.
#pragma once

#include "analyzer/flow/graph.hpp"
#include "analyzer/program/model.hpp"

#include <cstdint>
#include <vector>

namespace maclint::execution {

/// Whether the path needs each switch on or off; bit n is the switch of level n. Blocks that several levels
/// skip say nothing.
struct Switches {
    std::uint16_t on = 0;  ///< a block of the level is passed by
    std::uint16_t off = 0; ///< one is run
    friend bool operator==(const Switches&, const Switches&) = default;
};

class Skips {
  public:
    Skips(const Program& program, const flow::Graph& graph);

    [[nodiscard]] Switches at(flow::EdgeId edge) const {
        return edge < switches_.size() ? switches_[edge] : Switches{};
    }

  private:
    std::vector<Switches> switches_; ///< of each edge; empty: no block is ever skipped
};

} // namespace maclint::execution
