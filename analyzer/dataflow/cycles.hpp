//! What in a program can run again.
#pragma once

#include "analyzer/dataflow/solver/analysis.hpp"
#include "analyzer/flow/components.hpp"

#include <optional>

namespace maclint::dataflow {

/// The part of the flow graph that can be run, and which of its nodes can reach each other.
struct Cycles {
    flow::Adjacency adjacency;
    flow::Components components;
};

/// For each node where the edges lead that can be taken.
[[nodiscard]] flow::Adjacency adjacency_along(const flow::Graph& graph, const Analysis& analysis);

/// Whether the edge can be taken and leads to its own node or one before it.
[[nodiscard]] bool leads_back(const flow::Graph& graph, const Analysis& analysis, flow::EdgeId edge);

/// Nothing when no edge leads back.
[[nodiscard]] std::optional<Cycles> find_cycles(const flow::Graph& graph, const Analysis& analysis);

} // namespace maclint::dataflow
