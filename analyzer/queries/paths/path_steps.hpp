//! Shortest paths through a program, and which of their steps say something.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace maclint::queries {

/// The edges of a shortest path between two nodes over edges that can be taken; from a node to itself those
/// of a round that leads back there, from the program's first node none. Nothing when there is no such path,
/// or when the search from a node other than the first takes too long.
[[nodiscard]] std::optional<std::vector<flow::EdgeId>> shortest_path(const ProgramAnalysis& analysis,
                                                                     flow::NodeId from, flow::NodeId to);

/// The last steps of a path that do not simply go on to the next block, at most so many, in the order of the
/// path. Branches whose other side does not lead to the path's end are left out: there was no other way.
[[nodiscard]] std::vector<flow::EdgeId> telling_steps(const ProgramAnalysis& analysis,
                                                      std::span<const flow::EdgeId> path, std::size_t most);

/// The bytes at which the step is decided: the condition, the jump, or the block that it starts from.
[[nodiscard]] Span span_of_step(const ProgramAnalysis& analysis, flow::EdgeId step);
/// How a branch was decided: "true" or "false"; "once more" or "the program goes on" where the text writes no
/// condition, but a word that repeats a part of the program by itself.
[[nodiscard]] std::string_view outcome_of(const ProgramAnalysis& analysis, const flow::Edge& edge);

} // namespace maclint::queries
