//! The path of a finding that data flow made: from where a value came, over the jumps and branches, to its
//! place.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"
#include "rules/finding.hpp"

#include <span>
#include <string>

namespace maclint::rules {

/// Gives the finding, which stands in `node`, the path from `origin`. `begins` and `ends` say what happens
/// there.
void trace(Finding& finding, const ProgramAnalysis& analysis, dataflow::OriginId origin, std::string begins,
           flow::NodeId node, std::string ends);

/// The same from a place in the node `from`.
void trace(Finding& finding, const ProgramAnalysis& analysis, flow::NodeId from, RelatedLocation begins,
           flow::NodeId node, std::string ends);

/// The same from the program's start, where nothing happens.
void trace(Finding& finding, const ProgramAnalysis& analysis, flow::NodeId node, std::string ends);

/// Gives the finding a path to a variable of that name that may be vacant, from what makes it so: a known
/// call that leaves the argument out and then comes to the node, else the origin.
void trace_vacancy(Finding& finding, const ProgramAnalysis& analysis, dataflow::OriginId origin,
                   const std::string& name, flow::NodeId node, std::string ends);

/// Where such a path begins.
[[nodiscard]] RelatedLocation begin_of_vacancy(const ProgramAnalysis& analysis, dataflow::OriginId origin,
                                               std::span<const flow::EdgeId> path, std::string otherwise);

/// What happens on the path from the finding's place in `from` to `node`, as related places.
void report_path_on(Finding& finding, const ProgramAnalysis& analysis, flow::NodeId from, flow::NodeId node);

/// One round of a loop: from the finding's place in `node` back to it.
void trace_round(Finding& finding, const ProgramAnalysis& analysis, const dataflow::Loop& loop,
                 std::string ends);

} // namespace maclint::rules
