//! What a call of a program does to its caller, from the states with which the program is left.
#pragma once

#include "analyzer/dataflow/facts/fact_lists.hpp"
#include "analyzer/dataflow/solver/summary.hpp"
#include "analyzer/flow/graph.hpp"

#include <vector>

namespace maclint::dataflow {

class States;

/// What a summary is made from.
inline constexpr FactSet facts_of_summaries = facts<Store, Clobber, CallMade, ExitState>();

/// `facts`: those of the program, the states of its exits among them. `reached`: the nodes to which a path
/// leads.
[[nodiscard]] Summary summarise(const Program& program, const flow::Graph& graph, const Callees& callees,
                                States& states, const FactLists& facts, const std::vector<bool>& reached);

} // namespace maclint::dataflow
